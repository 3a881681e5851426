// H as a sum of parts whose flows are known.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns the system with the parts that its scene names, or else with parts that are found: the
/// terms of H, in their order, each in the first part that still has a known flow with it. Throws
/// InputError for parts whose sum is not H, with the difference, and MathError for a part whose
/// flow is not known. Precondition: the system is that of the scene, which is written out, a
/// Hamiltonian, and not in scaled time.
[[nodiscard]] System with_parts(System system, const WrittenOutScene& scene);

}  // namespace hvi::gen
