// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/device_module.hpp"

#include <utility>

#include "generator/emit/steps/emit.hpp"
#include "generator/module/driven.hpp"
#include "generator/module/stepper_part.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

DeviceModule device_module(const SceneStepper& stepper) {
    HVI_CHECK(stepper.step.layout == Layout::threads);
    HVI_CHECK(stepper.members.energy && stepper.members.invariants);
    DrivenSystem driven = driven_system(stepper.system);
    const std::string text = emit_class(stepper.method, stepper.step,
                                        {.class_name = stepper.class_name,
                                         .command = "",
                                         .system = &driven.system,
                                         .wishes = stepper.members,
                                         .evaluations = &stepper.evaluations.value()});
    Holes holes = stepper_holes(driven.system, stepper.class_name, text);
    holes.merge(Holes{{"skip", ""},
                      {"numbers", ""},
                      {"driven", "hvi/detail/device/rows.hpp"},
                      {"face", "hvi::device::DeviceRows"},
                      {"functions", "RowFunctions hvi_rows"}});
    return {fill("driven.cpp.in", holes), std::move(driven.numbers)};
}

}  // namespace hvi::gen
