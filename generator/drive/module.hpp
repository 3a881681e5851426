// A compiled module as a stepper of numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/drive/number_stepper.hpp"

namespace hvi::gen {

/// The paths from which a module's steppers are made.
struct ModuleStart {
    std::string path;       ///< path of the library
    std::string solvers;    ///< path of the library of its solvers; or empty
    std::string directory;  ///< the scene's directory, where its files are
    std::vector<double> parameters;
};

/// Loads a module, which stays loaded until the process ends, and returns a function that makes its
/// steppers. That function throws std::bad_alloc, and std::runtime_error with the module's message.
/// loaded_module() throws std::runtime_error where the file is no module of this version.
[[nodiscard]] MakeStepper loaded_module(ModuleStart start);

/// Loads a module, as loaded_module() does, for steppers of different parameters; those of the
/// `start` are not used. Throws as loaded_module() does.
[[nodiscard]] StepperFamily loaded_family(ModuleStart start);

}  // namespace hvi::gen
