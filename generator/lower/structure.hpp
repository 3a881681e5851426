// Second derivatives, and what a Hamiltonian is made of, as far as that is proved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The system with its second derivatives, and with its structure where it is an H of numbers: no
/// step for an L, or of rotations, takes anything of that. Precondition: it is written out, and its
/// slopes are there.
[[nodiscard]] System with_structure(System system);

}  // namespace hvi::gen
