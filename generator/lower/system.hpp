// From a Hamiltonian, or a whole scene, to a system, and what is found in it.
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

/// H with all that is found in it. A parameter that has a value is replaced by it; `parameters` are
/// the inputs among the others. Throws InputError as lower() does. Preconditions: those of lower().
[[nodiscard]] System system_of(const Hamiltonian& hamiltonian,
                               const std::vector<std::string>& parameters);

/// A pass that makes another H or L, with its slopes, before anything is found.
using SystemPass = std::function<System(System)>;

/// A scene that is written out, after these passes. Of its parameters those of H that have a value
/// are replaced.
[[nodiscard]] System system_of(const WrittenOutScene& scene,
                               const std::vector<SystemPass>& passes = {});

/// A scene whose sums stay loops, after these passes: for the sizes that it names and, by other
/// values of these, for any. Its L becomes the H of it before them. Throws InputError for a word
/// without a meaning and for an index that leaves its range for some value of those of its sums,
/// NoLoops for what is not built for systems of any size, and MathError for a number that is not
/// real.
[[nodiscard]] System system_of(const Scene& scene, const std::vector<SystemPass>& passes = {});

/// Properties that are proved of it. Costs of evaluations are those of a system that is written
/// out.
[[nodiscard]] SystemProperties properties(const System& system);
[[nodiscard]] SystemProperties properties(const System& system, const GradientKernels& gradients);

}  // namespace hvi::gen
