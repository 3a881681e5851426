// Cost and error of a step of strang with parts of H in an order.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// States of a system along its motion, each with all coordinates and then all conjugates.
using StatesOfMotion = std::vector<std::vector<double>>;

/// The error of the Hamiltonian of strang is h^2 times the sum, over all parts A but the last with
/// the sum B of those behind it, of
///
///     E = -{A, {A, B}}/24 + {B, {B, A}}/12,
///
/// and smaller terms. Returns the difference of the greatest and the least E at some states, over
/// the size of H, which is the sum of |A| at the first of them: h^2 times this is the relative
/// error of the energy there. Returns nothing where E has no value, or H no size. Precondition: the
/// system has parts.
[[nodiscard]] std::optional<double> split_error(System system, const WrittenOutScene& scene,
                                                const StatesOfMotion& states);

/// Returns the start of a scene and 128 states of its motion, at distances of steps of strang that
/// have an error of the energy of about a hundredth, or shorter ones: some periods. Returns nothing
/// where the scene has no initial state, or where no step of a method for any system follows the
/// motion. Precondition: the system has parts.
[[nodiscard]] std::optional<StatesOfMotion> states_of_motion(System system,
                                                             const WrittenOutScene& scene);

/// Returns the operations of the flows in a step of strang, with compensated sums, in additions. Of
/// steps in a row: the last flow of a step and the first one of the next are one. Precondition: the
/// system has parts.
[[nodiscard]] double cost_of_strang(const System& system);

}  // namespace hvi::gen
