// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/lanes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hvi::gen {

namespace {

/// NOTE: two equal stages are one, and have another weight in Q than in P.
bool all_are_solved_for(const std::vector<StageValue>& values) {
    return std::all_of(values.begin(), values.end(), [](const StageValue& value) {
        return value.place == StageValue::Place::inner && value.stages.size() == 1;
    });
}

/// Why the stages cannot all be the unknowns of one iteration.
std::string obstacle_in_stages(const Scheme& scheme) {
    if (scheme.blocks.size() > 1) { return "the stages are not solved for all at once"; }
    const bool are_unknowns =
        all_are_solved_for(scheme.positions) && all_are_solved_for(scheme.momenta);
    return are_unknowns ? "" : "some stages are equal, or the state itself";
}

}  // namespace

std::string obstacle_to_stage_lanes(const Scheme& scheme) {
    if (scheme.is_tabulated) { return "a step is one linear map"; }
    if (scheme.is_explicit()) { return "each stage of an explicit method needs the one before"; }
    if (scheme.from_parameter) { return "the coefficients depend on a parameter"; }
    if (scheme.solver != Solver::fixed_point && scheme.solver != Solver::automatic) {
        return "they are built for fixed points, and for these and Newton's method in turn";
    }
    return scheme.positions.size() == 1 ? "there is one stage" : obstacle_in_stages(scheme);
}

std::string obstacle_to_ensemble(const Scheme& scheme) {
    if (scheme.from_parameter) { return "the coefficients depend on a parameter"; }
    if (scheme.is_explicit()) { return ""; }
    if (scheme.solver != Solver::fixed_point) { return "they are iterated by fixed points"; }
    return obstacle_in_stages(scheme);
}

void set_lanes(Scheme& scheme, Lanes wished) {
    if (wished == Lanes::ensemble && obstacle_to_ensemble(scheme).empty()) {
        scheme.has_trajectory_lanes = true;
        scheme.decisions.push_back(
            {"eight trajectories are computed side by side",
             "one evaluation of dH/dq, in vectors of the processor, serves them all"});
    }
    if (wished == Lanes::ensemble || wished == Lanes::none ||
        !obstacle_to_stage_lanes(scheme).empty()) {
        return;
    }
    scheme.has_stage_lanes = true;
    scheme.decisions.push_back(
        {"the stages are computed side by side",
         fmt::format("one evaluation of dH/dq, in vectors of the processor, serves all {}",
                     scheme.positions.size())});
}

}  // namespace hvi::gen
