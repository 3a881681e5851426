// Entire functions of a parameter w near w = 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/exact/parameters/enclosed_function.hpp"

namespace hvi::gen {

/// Returns whether the first `order` coefficients of the series at w = 0 are zero, by normal forms.
[[nodiscard]] bool vanishes_at_zero(const EntireFunction& function,
                                    const EntireGenerators& generators, std::size_t order);

/// A function near w = 0, and the sum of the absolute values of its terms.
class NearZero {
public:
    /// Number of coefficients that the bounds treat one by one.
    static constexpr std::size_t longest = 64;

    NearZero(const EntireFunction& function, const EntireGenerators& generators);

    /// Returns the order of the first coefficient that is proved not to be zero.
    [[nodiscard]] unsigned order() const { return order_; }

    /// Returns whether |f| >= |leading w^order|/2 for |w| <= 2^at: no zero but w = 0, and a bound
    /// from below.
    [[nodiscard]] bool is_dominated(int at) const;

    /// Returns whether few digits are lost where the terms are added as they are written, at w =
    /// 2^at.
    [[nodiscard]] bool is_good_as_written(int at) const {
        return is_below(majorant_from(0, at), SeriesPlan::lost_bits, at);
    }

    /// Returns whether few digits are lost to the coefficients of the series, whose lower ones are
    /// known zeros.
    [[nodiscard]] bool is_good_as_series(int at) const {
        return is_below(majorant_from(order_, at), SeriesPlan::lost_bits, at);
    }

    /// Returns how many coefficients of the series are needed; empty where more than `longest` are.
    [[nodiscard]] std::optional<std::size_t> needed(int at) const;

private:
    [[nodiscard]] Ball majorant_from(std::size_t first, int at) const;
    [[nodiscard]] bool is_below(const Ball& sum, int exponent, int at) const;

    EnclosedFunction sum_of_sizes_;
    unsigned order_ = 0;
    Ball half_leading_;
    BallSeries coefficients_;
    BallSeries majorant_;
};

}  // namespace hvi::gen
