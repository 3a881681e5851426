// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/device_program.hpp"

#include <utility>

#include "generator/module/device_module.hpp"

namespace hvi::gen {

StepperWishes device_wishes(StepperWishes wishes, std::optional<Place> place) {
    wishes.lanes = {Lanes::gpu, std::move(place)};
    wishes.evaluations = false;
    return wishes;
}

SimulationProgram device_program(const SceneStepper& stepper, Artifact artifact) {
    DeviceModule made = device_module(stepper);
    return {
        {.main = std::move(made.source), .headers = {}, .artifact = artifact},
        {},
        {.file = {}, .directory = stepper.system.directory, .parameters = std::move(made.numbers)}};
}

}  // namespace hvi::gen
