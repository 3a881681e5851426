// Integrals without a closed form: Arb's rigorous quadrature (Petras' algorithm).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/functions/function.hpp"

namespace hvi::gen {

/// Returns the integral over [from, to] of a function without steps, as a number that is known by
/// its enclosures. Throws MathError where no enclosure is found, now or when later more digits are
/// asked for than can be had in reasonable time.
///
/// F. Johansson, "Numerical integration in arbitrary-precision ball arithmetic", ICMS 2018.
[[nodiscard]] Number quadrature(const ExactFunction& function, const Number& from, const Number& to,
                                const Ground& ground);

/// Returns whether a term has a root of a line, which may be zero at an end. A substitution makes
/// such a term analytic there, so that it is integrated alone.
[[nodiscard]] bool wants_substitution(const ExactTerm& term);

}  // namespace hvi::gen
