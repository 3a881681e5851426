// Energy of a system.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the system with its energy: H, or v dL/dv - L where the system is written out.
/// Precondition: slopes are there, and no sum of value 0.
[[nodiscard]] System with_energy(System system);

}  // namespace hvi::gen
