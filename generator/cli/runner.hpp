// A runner takes the steps of a run: a compiled module, or hvi-gen itself.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>

#include "generator/program/builds.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// Chooses how the steps of steppers are taken.
class Runner {
public:
    /// Looks for a compiler unless steps are to be interpreted.
    explicit Runner(const std::optional<Place>& interpret);

    [[nodiscard]] bool interprets() const { return !compiler_.has_value(); }

    /// Begins to compile a stepper in advance. Throws EnvironmentError where it is one for a GPU,
    /// and there is no compiler for that.
    void begin(const SceneStepper& stepper);

    /// Returns the compiled or interpreted steps. Throws InputError where steps cannot be
    /// interpreted, or EnvironmentError where there is no compiler and they cannot be interpreted
    /// either. Preconditions: begin() was called with the stepper, which lives longer.
    [[nodiscard]] Target target(const SceneStepper& stepper);

    /// Returns the compiled stepper; nothing where steps are interpreted. Precondition: begin() was
    /// called with it.
    [[nodiscard]] std::optional<Library> library(const SceneStepper& stepper) const;

private:
    std::optional<Place> interpret_;
    std::optional<Compiler> compiler_;
    std::optional<EnvironmentError> missing_;
    bool has_said_so_ = false;  ///< a message that there is no compiler was shown
    std::optional<Builds> builds_, device_builds_;
    std::map<const SceneStepper*, ModuleBuild> begun_;
};

}  // namespace hvi::gen
