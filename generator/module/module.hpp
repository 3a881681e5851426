// A stepper of a scene as a C module: a header, and a source file with its functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Texts of NAME.h and NAME.cpp.
struct CModule {
    std::string header, source;
};

/// Adds the members that modules need, and the name of its class, to the user's wishes.
[[nodiscard]] StepperWishes module_wishes(StepperWishes wishes, const std::string& name);

/// Writes the module. `command` writes it again. Preconditions: `stepper` is made with
/// module_wishes(), and `name` passes check_module_name().
[[nodiscard]] CModule c_module(const SceneStepper& stepper, const std::string& name,
                               const std::string& command);

}  // namespace hvi::gen
