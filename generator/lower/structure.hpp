// Second derivatives, and the structure of a Hamiltonian as far as it is proved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the system with its second derivatives, and with its structure, which is empty for an L
/// or for rotations. Precondition: its slopes are there, and where sums have loops the Sites of a
/// lattice.
[[nodiscard]] System with_structure(System system);

}  // namespace hvi::gen
