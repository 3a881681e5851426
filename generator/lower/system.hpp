// A system with all findings, from a Hamiltonian or a whole scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/ir/properties.hpp"
#include "generator/ir/system.hpp"
#include "generator/lower/gradient_kernels.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns H with all findings. A parameter that has a value is replaced by it; `parameters` are
/// the inputs among the others. Throws InputError as lower() does. Preconditions: those of lower().
[[nodiscard]] System system_of(const Hamiltonian& hamiltonian,
                               const std::vector<std::string>& parameters);

/// A pass that makes another H or L, with its slopes, before the structure is found.
using SystemPass = std::function<System(System)>;

/// Returns the system of a scene that is written out, after these passes. Parameters of H that have
/// a value are replaced by it.
[[nodiscard]] System system_of(const WrittenOutScene& scene,
                               const std::vector<SystemPass>& passes = {});

/// Returns the system of a scene whose sums stay loops, after these passes: for the sizes that it
/// names and, by other values of these, for any. An L is replaced by its H before the passes.
/// Throws InputError for a word without a meaning and for an index that leaves its range for some
/// value of the indices of its sums, NoLoops for parts that are not built for systems of any size,
/// and MathError for a number that is not real.
[[nodiscard]] System system_of(const Scene& scene, const std::vector<SystemPass>& passes = {});

/// Return properties that are proved. Costs of evaluations are known for a system that is written
/// out.
[[nodiscard]] SystemProperties properties(const System& system);
[[nodiscard]] SystemProperties properties(const System& system, const GradientKernels& gradients);

}  // namespace hvi::gen
