// A runner takes the steps of a run: a compiled module, or hvi-gen itself.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>

#include "generator/program/builds.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// Takes steppers to what takes their steps.
class Runner {
public:
    /// Looks for a compiler where none is to be done without.
    explicit Runner(const std::optional<Place>& interpret);

    [[nodiscard]] bool interprets() const { return !compiler_.has_value(); }

    /// Begins to compile what it will be asked for.
    void begin(const SceneStepper& stepper);

    /// Throws InputError where steps cannot be interpreted, or EnvironmentError where they had to
    /// be for want of a compiler. Preconditions: it has begun with the stepper, which lives longer.
    [[nodiscard]] Target target(const SceneStepper& stepper);

private:
    std::optional<Place> interpret_;
    std::optional<Compiler> compiler_;
    std::optional<EnvironmentError> missing_;
    bool has_said_so_ = false;  ///< that steps are interpreted for want of a compiler
    std::optional<Builds> builds_;
    std::map<const SceneStepper*, ModuleBuild> begun_;
};

}  // namespace hvi::gen
