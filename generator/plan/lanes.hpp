// Computation side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/plan/plan.hpp"

namespace hvi::gen {

/// Returns the reason why the stages of a step for a scene cannot be computed side by side; empty
/// where they can.
[[nodiscard]] std::string obstacle_to_stage_lanes(const Step& step);

/// Returns the reason why trajectories cannot be computed side by side; empty where they can.
[[nodiscard]] std::string obstacle_to_ensemble(const Step& step);

/// Whether trajectories could be computed side by side, with fixed points where a step of one
/// chooses its solver as it runs.
[[nodiscard]] bool may_go_side_by_side(const Step& step);

/// Returns the reason why a trajectory cannot be a thread of a GPU; empty where it can.
[[nodiscard]] std::string obstacle_to_threads(const Step& step);

/// Decides what lanes hold, by the wish and the obstacles. In vectors of any size they hold
/// components, where positions alone are solved for. Precondition: the solver is decided.
void set_lanes(Step& step, Lanes wished, const SystemProperties& system);

}  // namespace hvi::gen
