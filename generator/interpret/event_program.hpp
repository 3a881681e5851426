// Events of a scene, evaluated without a compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/drive/trajectory.hpp"
#include "generator/pipeline/stepper.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns the events of a scene for the parameters of the system. Throws as lowered_events() does,
/// and InputError for a cooldown or a period that is negative. Precondition: the system is written
/// out.
[[nodiscard]] std::vector<DrivenEvent> driven_events(const System& system,
                                                     const WrittenOutScene& scene);

/// Returns the motion of a Hamiltonian system without rotations and functions of the user's own,
/// for the parameters of the system. Preconditions: those of lowered_events(), and the time is a
/// coordinate.
[[nodiscard]] FindMotion driven_motion(const System& system, const WrittenOutScene& scene);

/// Returns the events of a scene whose sums stay loops. Throws as the function above.
[[nodiscard]] std::vector<DrivenEvent> driven_events(const Scene& scene);

}  // namespace hvi::gen
