// A system from a Hamiltonian, or a scene, that is written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns H and its gradient. A parameter that has a value is replaced by it; `parameters` are the
/// inputs among the others. Throws InputError as lower() does. Preconditions: those of lower().
[[nodiscard]] System named_system(const Hamiltonian& hamiltonian,
                                  const std::vector<std::string>& parameters);

/// Returns H or L, its gradient, and all else of a scene. Parameters of the function that have a
/// value are replaced by it.
[[nodiscard]] System named_system(const WrittenOutScene& scene);

}  // namespace hvi::gen
