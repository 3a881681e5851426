// A stepper of a scene as a module that hvi-gen compiles and drives itself.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// A system without values, which begins at parameters of its own where it can, and the numbers
/// that its steppers are made of: sizes, parameters, starting values, lists. Starting values stay
/// in the system where they depend on indices or files, or on functions of the user's own, lists
/// where one is in a file, and both where there are thousands.
struct DrivenSystem {
    System system;
    std::vector<double> numbers;
};

[[nodiscard]] DrivenSystem driven_system(const System& system);

/// A source, for src/hvi/detail/module/driven.hpp, and numbers as of a DrivenSystem. Solvers that
/// steps seldom call are a library of their own. The sources depend neither on values of
/// parameters, nor on sizes, nor on where the scene begins, so that what is compiled for one of
/// them serves all.
struct DrivenModule {
    std::string source;
    std::optional<std::string> solvers;  ///< the source of these
    std::vector<double> numbers;
};

/// Writes the module. Precondition: `stepper` is made with module_wishes().
[[nodiscard]] DrivenModule driven_module(const SceneStepper& stepper);

}  // namespace hvi::gen
