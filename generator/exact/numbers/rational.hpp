// Numbers that are rational, and rational exponents.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// A fraction above / below in lowest terms, below > 0.
struct Ratio {
    long above = 0;
    long below = 1;

    [[nodiscard]] bool is_integer() const { return below == 1; }
    [[nodiscard]] long floor() const;

    friend bool operator==(const Ratio& left, const Ratio& right) = default;
};

[[nodiscard]] Ratio ratio(long above, long below);  ///< precondition: below > 0
[[nodiscard]] Ratio operator+(const Ratio& left, const Ratio& right);
[[nodiscard]] Ratio operator*(const Ratio& left, const Ratio& right);
[[nodiscard]] Ratio operator-(const Ratio& argument);
[[nodiscard]] Number to_number(const Ratio& ratio);

/// Returns whether it is an element of the field, with a normal form: equality with others is
/// decided.
[[nodiscard]] bool is_exact(const Number& number);

/// Returns the number as `7` or `-2/3` when it is rational.
[[nodiscard]] std::optional<std::string> rational_text(const Number& number);

/// Returns the number as a ratio of integers of at most nine digits.
[[nodiscard]] std::optional<Ratio> small_ratio(const Number& number);

/// Returns the n-th root of a rational number that is not negative, where it is rational.
[[nodiscard]] std::optional<Number> rational_root(const Number& number, long n,
                                                  const Ground& ground);

/// Returns base^exponent for base >= 0; exact where square roots and perfect powers suffice. Throws
/// MathError for 0 to a negative power. Precondition: no free parameter unless the exponent is an
/// integer.
[[nodiscard]] Number power(const Number& base, const Ratio& exponent, const Ground& ground);

}  // namespace hvi::gen
