// Signs and zeros of functions: proved, or not claimed.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/functions/domain.hpp"
#include "generator/exact/functions/function.hpp"

namespace hvi::gen {

/// Known signs of a function on a domain. When there is no inner zero and nothing is undecided, the
/// function has the sign of its middle value everywhere, except at ends that are zeros.
struct Signs {
    bool zero_at_low = false;
    bool zero_at_high = false;
    std::optional<std::string> inner_zero;  ///< place of the first zero between the ends
    bool changes = false;                   ///< whether the sign is known to change there
    std::optional<std::string>
        undecided;  ///< a place at which a zero is neither found nor excluded

    /// Returns the place of a zero, also of one at an end.
    [[nodiscard]] std::optional<std::string> zero(const Domain& domain) const;
};

/// Finds the signs: of polynomials by their factors, of all others by bounds on smaller and smaller
/// intervals, up to a limit. Preconditions: not constant, no free parameter, no step.
[[nodiscard]] Signs signs(const ExactFunction& function, const Domain& domain,
                          const Ground& ground);

/// Returns a place where the function is negative, out of some tried ones.
[[nodiscard]] std::optional<std::string> negative_place(const ExactFunction& function,
                                                        const Domain& domain);

}  // namespace hvi::gen
