// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/side_by_side.hpp"

#include <utility>

#include "generator/plan/lanes.hpp"

namespace hvi::gen {

std::optional<SceneStepper> stepper_side_by_side(const SceneStepper& alone, const Method& method,
                                                 const Scene& scene, StepperWishes wishes) {
    const bool is_built = alone.system.is_written_out() && !alone.system.scaled &&
                          alone.own_headers.empty() && may_go_side_by_side(alone.step);
    if (!is_built) { return {}; }
    wishes.lanes = {Lanes::ensemble};
    wishes.evaluations = false;
    wishes.energy = wishes.invariants = true;
    return scene_stepper(method, scene, wishes);
}

}  // namespace hvi::gen
