// Names of Lie algebras.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace hvi::gen {

/// The constants of [e_i, e_j] = sum over k of constants[i][j][k] e_k.
using StructureConstants = std::vector<std::vector<std::vector<GiNaC::numeric>>>;

/// Returns the name `so(3)`, `se(3)+R`, ... of an algebra. Dimensions of the algebra, of its
/// derived algebra and of its centre, and the signs of Killing's form determine the isomorphism
/// class. Returns an empty text where they do not decide. Precondition: the constants are rational
/// and those of a Lie algebra.
[[nodiscard]] std::string name_of_algebra(const StructureConstants& constants);

}  // namespace hvi::gen
