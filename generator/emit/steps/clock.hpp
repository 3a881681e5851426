// What a step says of the time. All of it is empty where H does not depend on it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// The time of the position, or stage, i: `clock_.t[0]`; `s` is s_ in the stepper, and s in its
/// structs. And at the start of the step.
[[nodiscard]] std::string time_of_stage(const Step& step, std::string_view i, std::string_view s);
[[nodiscard]] std::string time_of_start(const Step& step, std::string_view s);

/// The same of the lanes that hold stages, and of the ones that hold trajectories.
[[nodiscard]] std::string times_of_lanes(const Step& step);
[[nodiscard]] std::string time_of_trajectories(const Step& step, std::string_view expression);

/// The line that declares the stepper's clock, and that of a reference to it.
[[nodiscard]] std::string clock_member(const Step& step);
[[nodiscard]] std::string clock_reference(const Step& step);

/// What step() does with it before anything else, and with the status at the end. `forget`: the
/// call for a step that does not begin at the time at which the last one ended.
[[nodiscard]] std::string clock_begins(const Step& step, std::string_view forget);
[[nodiscard]] std::string clock_ends(const Step& step, std::string_view status);
[[nodiscard]] std::string_view clock_ends_well(const Step& step);

/// The table of the c_i of step.c.
[[nodiscard]] std::string times_text(const Step& step);

/// `clock_, ` among the arguments of a struct of stage equations.
[[nodiscard]] std::string_view clock_argument(const Step& step);

/// The header of the runtime, by its path in src/hvi without the ending; none or one.
[[nodiscard]] std::vector<std::string> clock_runtime(const Step& step);

/// The class of the state, and the last template argument of states of several trajectories.
[[nodiscard]] std::string_view state_type(const Step& step);
[[nodiscard]] std::string_view trajectory_argument(const Step& step);

}  // namespace hvi::gen
