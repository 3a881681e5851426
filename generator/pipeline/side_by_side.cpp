// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/side_by_side.hpp"

#include <utility>

#include "generator/plan/lanes.hpp"

namespace hvi::gen {

namespace {

/// Whether eight trajectories are faster together than one after the other.
///
/// NOTE: stages of one trajectory fill registers as well, and eight have eight times as much to
/// keep in the nearest cache. Measured with AVX-512, time together over time alone: gauss:4 on
/// Henon-Heiles 0.42, gauss:8 0.57; FPU with 6 degrees of freedom, gauss:8, 0.87; outer solar
/// system with 18, gauss:2 0.83, gauss:4 1.1, gauss:8 1.25. Kicks and drifts have no stages.
bool is_faster(const SceneStepper& alone) {
    constexpr std::size_t most_unknowns = 64;
    const std::size_t unknowns = alone.system.degrees_of_freedom() * alone.step.positions.size();
    return alone.step.is_explicit() || unknowns <= most_unknowns;
}

}  // namespace

std::optional<SceneStepper> stepper_side_by_side(const SceneStepper& alone, const Method& method,
                                                 const Scene& scene, StepperWishes wishes) {
    const bool is_built = alone.system.is_written_out() && !alone.system.scaled &&
                          alone.own_headers.empty() && may_go_side_by_side(alone.step) &&
                          is_faster(alone);
    if (!is_built) { return {}; }
    wishes.lanes = {Lanes::ensemble};
    wishes.evaluations = false;
    wishes.energy = wishes.invariants = true;
    return scene_stepper(method, scene, wishes);
}

}  // namespace hvi::gen
