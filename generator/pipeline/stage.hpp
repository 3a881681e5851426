// Records on the way to a header, as texts.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/options/choices.hpp"
#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Returns the text that `hvi-gen stepper --dump` prints: the record as it was handed on.
[[nodiscard]] std::string dump(const Method& method, const SceneStepper& stepper,
                               const Wish<Stage>& stage);

/// Returns the text for a class of the user. Throws InputError for the system, which the user's
/// class is.
[[nodiscard]] std::string dump(const Method& method, const MethodStepper& stepper,
                               const Wish<Stage>& stage);

}  // namespace hvi::gen
