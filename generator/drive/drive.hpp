// Steps of a stepper of numbers, which hvi-gen takes in a process of its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "generator/drive/number_stepper.hpp"

namespace hvi::gen {

/// Runs the command of a line that begins with drive_word, and returns the exit status that
/// simulate/answers.cpp expects. Answers are lines of standard output: src/driver/answer.hpp.
[[nodiscard]] int drive(const std::vector<std::string_view>& words);

/// Runs a command on other steppers.
[[nodiscard]] int drive(const MakeStepper& make, const std::vector<std::string_view>& command);

}  // namespace hvi::gen
