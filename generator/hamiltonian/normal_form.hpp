// Operations of GiNaC's that may take very long in one go: what they take is said beforehand.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

namespace hvi::gen {

/// One fraction of polynomials, in which functions are free symbols. Spends work for the terms that
/// it has at most.
[[nodiscard]] GiNaC::ex normal_form(const GiNaC::ex& expression);

/// Spends the work of normal_form(), for callers that ask GiNaC for the parts of that fraction.
void spend_on_normal_form(const GiNaC::ex& expression);

/// The greatest common divisor of polynomials. Spends work for all pairs of their terms.
[[nodiscard]] GiNaC::ex common_divisor(const GiNaC::ex& a, const GiNaC::ex& b);

/// Multiplied out; as it stands where that may have more than 20 000 terms.
[[nodiscard]] GiNaC::ex multiplied_out(const GiNaC::ex& expression);

}  // namespace hvi::gen
