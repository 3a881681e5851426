// What is computed side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/plan/scheme.hpp"

namespace hvi::gen {

/// Why the stages of a scheme for a scene cannot be computed side by side; empty where they can.
[[nodiscard]] std::string obstacle_to_stage_lanes(const Scheme& scheme);

/// Why trajectories cannot; empty where they can.
[[nodiscard]] std::string obstacle_to_ensemble(const Scheme& scheme);

/// Decides it from what is wished for and what can be had; see the obstacles.
/// Precondition: the solver is decided.
void set_lanes(Scheme& scheme, Lanes wished);

}  // namespace hvi::gen
