// Which of the usual Lie algebras one is.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace hvi::gen {

/// [e_i, e_j] = sum over k of constants[i][j][k] e_k.
using StructureConstants = std::vector<std::vector<std::vector<GiNaC::numeric>>>;

/// `so(3)`, `se(3)+R`, ... by what determines the class of algebras that are the same up to a
/// change of the basis: the dimensions of the algebra, of what brackets span and of what commutes
/// with all, and the signs of Killing's form. Empty where these do not decide. Precondition: they
/// are rational and those of a Lie algebra.
[[nodiscard]] std::string name_of_algebra(const StructureConstants& constants);

}  // namespace hvi::gen
