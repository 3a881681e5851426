// What is computed side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/plan/plan.hpp"

namespace hvi::gen {

/// Why the stages of a step for a scene cannot be computed side by side; empty where they can.
[[nodiscard]] std::string obstacle_to_stage_lanes(const Step& step);

/// Why trajectories cannot; empty where they can.
[[nodiscard]] std::string obstacle_to_ensemble(const Step& step);

/// Decides it from what is wished for and what can be had; see the obstacles. Of vectors of any
/// size that are components, where positions alone are solved for. Precondition: the solver is
/// decided.
void set_lanes(Step& step, Lanes wished, const SystemProperties& system);

}  // namespace hvi::gen
