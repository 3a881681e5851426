// A compiled module as a stepper of numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/drive/number_stepper.hpp"

namespace hvi::gen {

/// Words that make steppers of a module.
struct ModuleStart {
    std::string path;       ///< of the library
    std::string solvers;    ///< path of the library of its solvers; or empty
    std::string directory;  ///< of the scene, whose files are found from there
    std::vector<double> parameters;
};

/// Loads a module, which stays so until the process ends, and makes steppers of it. These throw
/// std::bad_alloc, and std::runtime_error with what the module says; so does this where the file is
/// no module of this version.
[[nodiscard]] MakeStepper loaded_module(ModuleStart start);

}  // namespace hvi::gen
