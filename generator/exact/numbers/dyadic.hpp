// Numbers that binary formats hold.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// Integer of 128 bits. NOTE: a type of g++ and clang, no part of C++: wide enough for the 113 bits
/// of binary128.
__extension__ using WideInteger = __int128;

/// A number integer * 2^exponent, exactly; the integer is odd, or zero with the exponent 0.
class Dyadic {
public:
    static constexpr int most_bits = 126;

    Dyadic() = default;
    Dyadic(WideInteger integer, int exponent) : integer_(integer), exponent_(exponent) {
        if (integer == 0) { exponent_ = 0; }
        while (integer_ != 0 && integer_ % 2 == 0) {
            integer_ /= 2;
            ++exponent_;
        }
        HVI_CHECK(bits() <= most_bits);
    }

    [[nodiscard]] bool is_zero() const { return integer_ == 0; }
    /// Returns the integer, which is odd or zero.
    [[nodiscard]] WideInteger integer() const { return integer_; }
    /// Returns the number of bits of the integer.
    [[nodiscard]] int bits() const {
        int count = 0;
        for (WideInteger rest = integer_; rest != 0; rest /= 2) { ++count; }
        return count;
    }
    /// Return the powers of two of the last and the leading bit. Precondition for the second: not
    /// zero.
    [[nodiscard]] int last() const { return exponent_; }
    [[nodiscard]] int leading() const { return exponent_ + bits() - 1; }

    /// Returns the difference. Precondition: it has no more than most_bits bits.
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) {
        if (a.is_zero()) { return {-b.integer_, b.exponent_}; }
        if (b.is_zero()) { return a; }
        const int exponent = std::min(a.exponent_, b.exponent_);
        HVI_CHECK(std::max(a.leading(), b.leading()) - exponent < most_bits);
        const auto shifted = [&](const Dyadic& x) {
            return x.integer_ * (WideInteger(1) << (x.exponent_ - exponent));
        };
        return {shifted(a) - shifted(b), exponent};
    }
    friend bool operator==(const Dyadic&, const Dyadic&) = default;

    /// Returns the number with all but its first `count` bits cut off.
    [[nodiscard]] Dyadic cut(int count) const {
        const int surplus = std::max(bits() - count, 0);
        return {integer_ / (WideInteger(1) << surplus), exponent_ + surplus};
    }

    /// Returns the number as a double. Precondition: there is one.
    [[nodiscard]] double to_double() const {
        const double value = std::ldexp(static_cast<double>(integer_), exponent_);
        HVI_CHECK(bits() <= 53 && std::isfinite(value) && (value != 0.0 || is_zero()));
        HVI_CHECK(is_zero() || exponent_ >= -1074);
        return value;
    }

private:
    WideInteger integer_ = 0;
    int exponent_ = 0;
};

}  // namespace hvi::gen
