// Answers yes or no, with their evidence.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/numbers/ball.hpp"
#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// An answer. It is proved by exact arithmetic, or by an enclosure that excludes its contrary. An
/// answer that is not proved is a yes that rests on enclosures of zero narrower than 10^-50.
struct Verdict {
    bool holds = true;
    bool proved = true;

    /// Returns whether both hold.
    friend Verdict operator&&(const Verdict& left, const Verdict& right) {
        if (!left.holds || !right.holds) {
            return {false, (!left.holds && left.proved) || (!right.holds && right.proved)};
        }
        return {true, left.proved && right.proved};
    }
};

/// Returns whether a number in a ball is zero; empty when the ball contains zero and is too wide.
[[nodiscard]] std::optional<Verdict> vanishes(const Ball& ball);

/// Returns whether a number is zero. Throws MathError when its enclosures do not get narrow enough.
[[nodiscard]] Verdict vanishes(const Number& number);

/// Returns whether a number can be zero that is known to some digits only: unless its enclosure
/// with so many bits excludes that.
[[nodiscard]] Verdict can_vanish(const Number& number, Precision bits);

}  // namespace hvi::gen
