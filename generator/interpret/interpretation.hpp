// A scene and a method that are run without a compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/drive/number_stepper.hpp"
#include "generator/interpret/system_program.hpp"
#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Returns why a stepper cannot be interpreted; empty where it can.
[[nodiscard]] std::string obstacle_to_interpretation(const SceneStepper& stepper);

/// Returns steppers, for any parameters and starting values, that compute the bits of a compiled
/// module in which no product is fused with a sum. Where fixed points are too slow they throw
/// SolverIsApart: Newton's method is to come. Preconditions: there is no obstacle, and `stepper` is
/// made with module_wishes().
[[nodiscard]] StepperFamily interpretations(const SceneStepper& stepper);

}  // namespace hvi::gen
