// The records on the way to a header, as texts.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// What `hvi-gen stepper --dump` prints, in the order in which it is made.
enum class Stage {
    method,   ///< as it was read
    tableau,  ///< its exact coefficients
    system,   ///< H, its derivatives and the rest of a scene, as a graph
    step,     ///< what is solved, evaluated and kept, and why
};

/// The record as it was handed on.
[[nodiscard]] std::string dump(const Method& method, const SceneStepper& stepper, Stage stage);

/// The same. Throws InputError for the system, which the user's class is.
[[nodiscard]] std::string dump(const Method& method, const MethodStepper& stepper, Stage stage);

}  // namespace hvi::gen
