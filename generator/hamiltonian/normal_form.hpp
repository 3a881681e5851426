// GiNaC's operations that may take very long at once. Their work is estimated and spent beforehand.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

namespace hvi::gen {

/// Returns one fraction of polynomials, in which functions are free symbols. Spends work for the
/// most terms that the fraction may have.
[[nodiscard]] GiNaC::ex normal_form(const GiNaC::ex& expression);

/// Spends the work of normal_form(), for callers that ask GiNaC for the parts of that fraction.
void spend_on_normal_form(const GiNaC::ex& expression);

/// Returns the greatest common divisor of polynomials. Spends work for all pairs of their terms.
[[nodiscard]] GiNaC::ex common_divisor(const GiNaC::ex& a, const GiNaC::ex& b);

/// Multiplies the expression out; returns it unchanged where that may give more than 20 000 terms.
[[nodiscard]] GiNaC::ex multiplied_out(const GiNaC::ex& expression);

}  // namespace hvi::gen
