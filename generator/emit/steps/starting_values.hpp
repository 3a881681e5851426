// Slopes that an iteration begins with: those of the last step or two, extrapolated.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

/// The comment and the first line of predict(). `slopes`: what the starting values are.
void open_predict(Writer& writer, const Scheme& scheme, std::string_view slopes);

/// The tables N, and N_before, of starting values.
[[nodiscard]] std::string extrapolation_text(const Scheme& scheme);

/// The slopes that starting values are of: W, or Lq and Lp.
[[nodiscard]] std::vector<std::string_view> predicted_slopes(const Scheme& scheme);

/// The lines of predict() around those that extrapolate. Precondition: there is an extrapolation.
void open_extrapolation(Writer& writer, const Scheme& scheme);
void close_extrapolation(Writer& writer, const Scheme& scheme);

/// Members: the slopes of the step before the last, where starting values are made of them.
void declare_slopes_before(Writer& writer, const Scheme& scheme);

/// sum_j N_ij L_j, of the slopes called `slope`_1, ..., and `slope`_before_1, ....
[[nodiscard]] std::string extrapolated(const Scheme& scheme, std::size_t i, std::string_view slope);

/// These slopes of component k of the stepper; those of the last step become those before it.
void recall_slopes(Writer& writer, const Scheme& scheme, std::string_view slope);

}  // namespace hvi::gen
