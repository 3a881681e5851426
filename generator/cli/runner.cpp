// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/runner.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "generator/interpret/interpretation.hpp"
#include "generator/module/driven.hpp"
#include "generator/simulate/device_program.hpp"

namespace hvi::gen {

Runner::Runner(const std::optional<Place>& interpret) : interpret_(interpret) {
    if (interpret) return;
    try {
        compiler_ = find_compiler();
    } catch (const EnvironmentError& error) { missing_ = error; }
}

void Runner::begin(const SceneStepper& stepper) {
    if (stepper.step.layout == Layout::threads) {
        if (!device_builds_) device_builds_.emplace(find_device_compiler());
        begun_.emplace(&stepper, device_program(stepper).order(*device_builds_));
        return;
    }
    if (!compiler_) return;
    if (!builds_) builds_.emplace(*compiler_);
    begun_.emplace(&stepper, simulation_program(stepper).order(*builds_));
}

std::optional<Library> Runner::library(const SceneStepper& stepper) const {
    const auto found = begun_.find(&stepper);
    if (found == begun_.end()) return {};
    return std::get<Library>(found->second.target());
}

Target Runner::target(const SceneStepper& stepper) {
    if (compiler_) return begun_.at(&stepper).target();
    const std::string obstacle = obstacle_to_interpretation(stepper);
    if (!obstacle.empty() && missing_) throw *missing_;
    if (!obstacle.empty())
        throw InputError("this cannot be run without a compiler: " + obstacle, interpret_,
                         "what can be is in docs/interpreter.md");
    if (missing_ && !std::exchange(has_said_so_, true))
        std::fputs(fmt::format("note: {}; steps are interpreted\n", missing_->what()).c_str(),
                   stderr);
    return Interpreted{interpretations(stepper), driven_system(stepper.system).numbers};
}

}  // namespace hvi::gen
