// A package in Python around the library of a module.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// A file of a package, by its name in the folder of the package.
struct PackageFile {
    std::string name, text;
};

/// A parameter whose default is computed from other parameters.
struct ComputedParameter {
    std::string name;
    std::string formula;  ///< in the scene's words: `(N+1)/32`
};

/// Parts of the scene that a stepper does not have.
struct PackageScene {
    std::optional<double> step, until;        ///< of its [run]
    std::vector<ComputedParameter> computed;  ///< in the order of the scene
};

/// Returns the name of the library in a package of that name.
[[nodiscard]] std::string package_library(const std::string& name);

/// Writes the files of the package beside its library: the class Stepper, the files of the package
/// hvi that it needs, and defaults of parameters, which the library does not know. `command` writes
/// them again. Preconditions are those of c_module().
[[nodiscard]] std::vector<PackageFile> python_package(const SceneStepper& stepper,
                                                      const std::string& name,
                                                      const std::string& command,
                                                      const PackageScene& scene);

}  // namespace hvi::gen
