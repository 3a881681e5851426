// From a Hamiltonian, or a whole scene, to a system.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/ir/properties.hpp"
#include "generator/ir/system.hpp"
#include "generator/lower/gradient_kernels.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// H, its gradient and its structure. A parameter that has a value is replaced by it; `parameters`
/// are the inputs among the others. Throws InputError as lower() does. Preconditions: those of
/// lower(). The result is verified.
[[nodiscard]] System system_of(const Hamiltonian& hamiltonian,
                               const std::vector<std::string>& parameters);

/// The same with all that a scene has. Of its parameters those of H that have a value are replaced.
[[nodiscard]] System system_of(const WrittenOutScene& scene);

/// What is proved of it. Costs of evaluations are those of a system that is written out.
[[nodiscard]] SystemProperties properties(const System& system);
[[nodiscard]] SystemProperties properties(const System& system, const GradientKernels& gradients);

}  // namespace hvi::gen
