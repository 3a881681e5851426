// Slopes that an iteration begins with, extrapolated from the slopes of the last step or two.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

/// Writes the comment and the first line of predict(). `slopes` names the starting values.
void open_predict(Writer& writer, const Iteration& iteration, std::string_view slopes);

/// Writes a table for the computation of starting values.
void starting_table(Writer& writer, std::string_view name, const NumberMatrix& exact);

/// Returns the tables N, and N_before, of starting values.
[[nodiscard]] std::string extrapolation_text(const Iteration& iteration);

/// Writes `name`_lanes, the columns of a table.
void columns(Writer& writer, std::string_view name);

/// Writes the columns of the tables of starting values, for stages in lanes.
void columns_of_extrapolation(Writer& writer, const Iteration& iteration);

/// Returns the slopes that have starting values: W, or Lq and Lp.
[[nodiscard]] std::vector<std::string_view> predicted_slopes(const Step& step);

/// Write the lines of predict() around those that extrapolate slopes.
void open_extrapolation(Writer& writer, const Extrapolation& from);
void close_extrapolation(Writer& writer, const Extrapolation& from,
                         const std::vector<std::string_view>& slopes);

/// Declares members for the slopes of the step before the last, where starting values need them.
void declare_slopes_before(Writer& writer, const Step& step);

/// Returns sum_j N_ij L_j, of the slopes called `slope`_1, ..., and `slope`_before_1, ....
[[nodiscard]] std::string extrapolated(const Extrapolation& from, std::size_t i,
                                       std::string_view slope);

/// Writes the lines that load component k of these slopes in the stepper; slopes of the last step
/// become slopes of the step before the last.
void recall_slopes(Writer& writer, const Extrapolation& from, std::string_view slope);

}  // namespace hvi::gen
