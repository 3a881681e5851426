// A stepper of a scene as a C module: a header, and a source file with its functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Texts of NAME.h and NAME.cpp.
struct CModule {
    std::string header, source;
};

/// Adds what a module computes of states, and the name of its class, to what a user wishes for.
[[nodiscard]] StepperWishes module_wishes(StepperWishes wishes, const std::string& name);

/// Writes the module. `command` writes it again. Preconditions: `stepper` is made with
/// module_wishes(), and `name` passes check_module_name().
[[nodiscard]] CModule c_module(const SceneStepper& stepper, const std::string& name,
                               const std::string& command);

/// The source of a module that hvi-gen drives itself: src/hvi/detail/module/driven.hpp. Its text
/// does not depend on values of parameters and on sizes, so that what is compiled for one of them
/// serves all. Precondition: as of c_module().
[[nodiscard]] std::string driven_module(const SceneStepper& stepper);

/// Values of sizes, then of parameters, as such a module takes them; lists stay in it.
[[nodiscard]] std::vector<double> driven_parameters(const System& system);

}  // namespace hvi::gen
