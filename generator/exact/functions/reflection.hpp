// Reflections of functions: a function that is odd about the middle of an interval has the integral
// 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/functions/function.hpp"

namespace hvi::gen {

/// Returns whether f(end - tau) = -f(tau) by the normal form: a zero integral that enclosures
/// cannot prove.
[[nodiscard]] bool is_odd_about_middle(const ExactFunction& function, const Number& end,
                                       const Ground& ground);

}  // namespace hvi::gen
