// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/side_by_side.hpp"

#include <utility>

#include "generator/pipeline/passes.hpp"
#include "generator/plan/lanes.hpp"

namespace hvi::gen {

namespace {

/// Whether eight trajectories are faster together than one after the other.
///
/// NOTE: stages of one trajectory fill registers as well, and eight have eight times as much to
/// keep in the nearest cache. Measured with AVX-512, time together over time alone: gauss:4 on
/// Henon-Heiles 0.42, gauss:8 0.57; FPU with 6 degrees of freedom, gauss:8, 0.87; outer solar
/// system with 18, gauss:2 0.83, gauss:4 1.1, gauss:8 1.25. Kicks and drifts have no stages.
/// `degrees` are the degrees of freedom, those of a direction included.
bool is_faster(const Step& step, std::size_t degrees) {
    constexpr std::size_t most_unknowns = 64;
    return step.is_explicit() || degrees * step.positions.size() <= most_unknowns;
}

/// Whether trajectories, with so many directions each, go side by side, and are faster there.
bool go_side_by_side(const SceneStepper& alone, std::size_t directions) {
    return alone.system.is_written_out() && !alone.system.scaled && alone.own_headers.empty() &&
           may_go_side_by_side(alone.step) &&
           is_faster(alone.step, alone.system.degrees_of_freedom() * (1 + directions));
}

StepperWishes wishes_of_eight(StepperWishes wishes) {
    wishes.lanes = {Lanes::ensemble};
    wishes.evaluations = false;
    wishes.energy = wishes.invariants = true;
    return wishes;
}

}  // namespace

std::optional<SceneStepper> stepper_side_by_side(const SceneStepper& alone, const Method& method,
                                                 const Scene& scene, StepperWishes wishes) {
    if (!go_side_by_side(alone, 0)) { return {}; }
    return scene_stepper(method, scene, wishes_of_eight(std::move(wishes)));
}

std::optional<SceneStepper> tangent_stepper_side_by_side(const SceneStepper& alone,
                                                         const Method& method, const Scene& scene,
                                                         StepperWishes wishes) {
    const bool is_built =
        go_side_by_side(alone, 1) && alone.system.side == Side::hamiltonian && !alone.system.parts;
    if (!is_built) { return {}; }
    return tangent_stepper(method, scene, wishes_of_eight(std::move(wishes)), "a direction");
}

}  // namespace hvi::gen
