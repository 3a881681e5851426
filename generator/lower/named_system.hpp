// From a Hamiltonian, or a scene, that is written out to a system.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// H and its gradient, with a parameter that has a value replaced by it; `parameters` are the
/// inputs among the others. Throws InputError as lower() does. Preconditions: those of lower().
[[nodiscard]] System named_system(const Hamiltonian& hamiltonian,
                                  const std::vector<std::string>& parameters);

/// H or L, its gradient, and all else that a scene has. Of its parameters those of the function
/// that have a value are replaced.
[[nodiscard]] System named_system(const WrittenOutScene& scene);

}  // namespace hvi::gen
