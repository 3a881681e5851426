// Fractions of small integers: the factors that a graph folds.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <compare>
#include <numeric>
#include <optional>

namespace hvi::gen {

/// A fraction above / below in lowest terms, below > 0, both at most `largest` in size. Larger
/// numbers stand in a graph as constants.
struct SmallFraction {
    static constexpr long largest = 1'000'000'000;

    long above = 0;
    long below = 1;

    /// Returns a fraction in lowest terms; empty where it is too large. Precondition: the divisor
    /// is not zero, and both are less than 2^62 in size.
    [[nodiscard]] static std::optional<SmallFraction> of(long dividend, long divisor) {
        const long common =
            divisor < 0 ? -std::gcd(dividend, divisor) : std::gcd(dividend, divisor);
        const SmallFraction result{dividend / common, divisor / common};
        const bool fits =
            -largest <= result.above && result.above <= largest && result.below <= largest;
        return fits ? std::optional(result) : std::nullopt;
    }

    [[nodiscard]] bool is_zero() const { return above == 0; }
    [[nodiscard]] bool is_one() const { return above == 1 && below == 1; }
    [[nodiscard]] SmallFraction size() const { return {above < 0 ? -above : above, below}; }

    friend auto operator<=>(const SmallFraction&, const SmallFraction&) = default;
    friend SmallFraction operator-(const SmallFraction& a) { return {-a.above, a.below}; }
    /// Returns the sum; empty where it is too large.
    friend std::optional<SmallFraction> operator+(const SmallFraction& a, const SmallFraction& b) {
        return of(a.above * b.below + b.above * a.below, a.below * b.below);
    }
    friend std::optional<SmallFraction> operator*(const SmallFraction& a, const SmallFraction& b) {
        return of(a.above * b.above, a.below * b.below);
    }
};

}  // namespace hvi::gen
