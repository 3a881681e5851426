// Slopes that an iteration begins with: those of the last step or two, extrapolated.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

/// The comment and the first line of predict(). `slopes`: what the starting values are.
void open_predict(Writer& writer, const Iteration& iteration, std::string_view slopes);

/// A table that starting values are computed with.
void starting_table(Writer& writer, std::string_view name, const NumberMatrix& exact);

/// The tables N, and N_before, of starting values.
[[nodiscard]] std::string extrapolation_text(const Iteration& iteration);

/// The slopes that starting values are of: W, or Lq and Lp.
[[nodiscard]] std::vector<std::string_view> predicted_slopes(const Step& step);

/// The lines of predict() around those that extrapolate slopes.
void open_extrapolation(Writer& writer, const Extrapolation& from);
void close_extrapolation(Writer& writer, const Extrapolation& from,
                         const std::vector<std::string_view>& slopes);

/// Members: the slopes of the step before the last, where starting values are made of them.
void declare_slopes_before(Writer& writer, const Step& step);

/// sum_j N_ij L_j, of the slopes called `slope`_1, ..., and `slope`_before_1, ....
[[nodiscard]] std::string extrapolated(const Extrapolation& from, std::size_t i,
                                       std::string_view slope);

/// These slopes of component k of the stepper; those of the last step become those before it.
void recall_slopes(Writer& writer, const Extrapolation& from, std::string_view slope);

}  // namespace hvi::gen
