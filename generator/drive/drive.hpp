// Drives steppers of numbers in a copy of the process: a step may crash, or never end.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "generator/drive/balance.hpp"
#include "generator/drive/eventful_run.hpp"
#include "generator/drive/number_stepper.hpp"
#include "generator/drive/shadow.hpp"
#include "generator/drive/tangents.hpp"
#include "generator/drive/trajectory.hpp"

namespace hvi::gen {

/// The exit status where a step calls for solvers that were not given.
inline constexpr int solver_is_apart = 6;

/// The word before a command that computes invariants only where rows are written, not at each
/// step.
inline constexpr const char* rows_word = "rows";

/// Finds steppers. Throws as loaded_module() does.
using FindSteppers = std::function<MakeStepper()>;

/// Runs a command of src/driver on the steppers, and returns the exit status that
/// simulate/answers.cpp expects. Answers are lines of standard output: src/driver/answer.hpp.
[[nodiscard]] int drive(const FindSteppers& find, const std::vector<std::string_view>& command);

/// Take the steps of a trajectory, of directions, of a modified Hamiltonian, of a balance, or of a
/// run with events that is measured.
[[nodiscard]] int drive(const FindSteppers& find, const TrajectoryWishes& wishes);
[[nodiscard]] int drive(const FindSteppers& find, const TangentWishes& wishes);
[[nodiscard]] int drive(const FindSteppers& find, const ShadowWishes& wishes);
[[nodiscard]] int drive(const FindSteppers& find, const BalanceWishes& wishes);
[[nodiscard]] int drive(const FindSteppers& find, const EventfulRunWishes& wishes);

}  // namespace hvi::gen
