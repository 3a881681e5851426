// Code of steps for the directions that they carry along.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/plan/evaluations.hpp"

namespace hvi::gen {

// All are empty where a step carries none, and for flows, whose headers have their own.

/// The public type of what it carries.
[[nodiscard]] std::string type_of_along(const Step& step, const Evaluations* evaluations);

/// The header of the runtime that has it, as it is included before the class.
[[nodiscard]] std::string include_of_along(const Step& step);

/// Whether step() itself is called, or a part of it.
enum class StepFunction { whole, part };

/// Behind the size of the step: an argument, and what is passed for it.
[[nodiscard]] std::string along_argument(const Step& step, StepFunction function);
[[nodiscard]] std::string_view along_passed(const Step& step);

// ---- kicks and drifts ----

/// Carries directions along a move of that size, from where its slope is evaluated.
[[nodiscard]] std::string carry_by_move(const Step& step, const Move& move, std::string_view at,
                                        std::string_view size);
/// Looks whether they are finite, before x is moved.
[[nodiscard]] std::string end_of_moves(const Step& step);

// ---- stages ----

/// The lines of a step that call carry(), where all slopes are known and x is not moved yet.
[[nodiscard]] std::string call_of_carry(const Step& step);

/// Adds carry() to the members, and the tables that it takes to the constants.
void add_carry(ImplicitParts& parts, const Step& step);

}  // namespace hvi::gen
