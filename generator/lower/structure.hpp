// Second derivatives, and what a Hamiltonian is made of, as far as that is proved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The system with its second derivatives, and with its structure: of an L or of rotations that is
/// none. Precondition: its slopes are there, and where sums have loops the Sites of a lattice.
[[nodiscard]] System with_structure(System system);

}  // namespace hvi::gen
