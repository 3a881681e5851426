// Texts of a step about time. All of them are empty where H does not depend on time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Return the time of the position, or stage, i, `clock_.t[0]`, and the time at the start of the
/// step. `s` is s_ in the stepper, and s in its structs.
[[nodiscard]] std::string time_of_stage(const Step& step, std::string_view i, std::string_view s);
[[nodiscard]] std::string time_of_start(const Step& step, std::string_view s);

/// Returns the time of stage i where a trajectory is a thread.
[[nodiscard]] std::string time_of_thread(const Step& step, std::string_view i);

/// Return the times of lanes that hold stages, and the time of lanes that hold trajectories.
[[nodiscard]] std::string times_of_lanes(const Step& step);
[[nodiscard]] std::string time_of_trajectories(const Step& step, std::string_view expression);

/// Return the line that declares the stepper's clock, and the line that declares a reference to it.
[[nodiscard]] std::string clock_member(const Step& step);
[[nodiscard]] std::string clock_reference(const Step& step);

/// Return the lines of step() that begin the clock, before anything else, and end it, with the
/// status. `forget`: the call for a step that does not begin at the time at which the last one
/// ended.
[[nodiscard]] std::string clock_begins(const Step& step, std::string_view forget);
[[nodiscard]] std::string clock_ends(const Step& step, std::string_view status);
[[nodiscard]] std::string_view clock_ends_well(const Step& step);

/// Returns the table of the c_i of step.c.
[[nodiscard]] std::string times_text(const Step& step);

/// Returns `clock_, ` among the arguments of a struct of stage equations.
[[nodiscard]] std::string_view clock_argument(const Step& step);

/// Returns the header of the runtime, by its path in src/hvi without the ending; none or one.
[[nodiscard]] std::vector<std::string> clock_runtime(const Step& step);

/// Return the class of the state, and the last template argument of states of several trajectories.
[[nodiscard]] std::string_view state_type(const Step& step);
[[nodiscard]] std::string_view trajectory_argument(const Step& step);

}  // namespace hvi::gen
