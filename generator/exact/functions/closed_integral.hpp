// Integrals in closed form of tau^k times a factor.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/functions/factor.hpp"

namespace hvi::gen {

/// Returns the integral of tau^k * factor(tau) over [from, to], where a formula is known. Its value
/// may still have to be enclosed, as that of atan(2). Throws MathError when it is infinite.
[[nodiscard]] std::optional<Number> closed_integral(const Factor& factor, unsigned k,
                                                    const Number& from, const Number& to,
                                                    const Ground& ground);

}  // namespace hvi::gen
