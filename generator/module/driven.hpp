// A stepper of a scene as a module that hvi-gen compiles and drives itself.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// A system without values, and the numbers of its steppers: sizes, parameters, starting values,
/// lists. Starting values become parameters of the system where they can. They stay in the system
/// where they depend on indices or files, or on functions of the user's own; lists stay where one
/// is in a file; both stay where there are thousands.
struct DrivenSystem {
    System system;
    std::vector<double> numbers;
};

[[nodiscard]] DrivenSystem driven_system(const System& system);

/// A source, for src/hvi/detail/module/driven.hpp, and numbers as in a DrivenSystem. Solvers that
/// steps seldom call are a library of their own. The sources depend neither on values of
/// parameters, nor on sizes, nor on the start of the scene, so that one compiled module serves for
/// all of these.
struct DrivenModule {
    std::string source;
    std::optional<std::string> solvers;  ///< the source of that library
    std::vector<double> numbers;
};

/// Writes the module. Precondition: `stepper` is made with module_wishes().
[[nodiscard]] DrivenModule driven_module(const SceneStepper& stepper);

}  // namespace hvi::gen
