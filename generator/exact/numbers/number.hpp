// Real numbers: exact where a closed form exists, certified everywhere.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "generator/exact/numbers/dyadic.hpp"
#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// An immutable real number, or a function of free parameters. Arithmetic is exact, as far as the
/// field's Budget goes: a result beyond it is known by its enclosures, and with free parameters in
/// the field TooLarge is thrown. Numbers that meet in one operation come from one Field (rationals
/// fit everywhere).
class Number {
public:
    Number() : Number(0) {}
    Number(long value);  // NOLINT(google-explicit-constructor): integers are numbers

    friend Number operator+(const Number& left, const Number& right);
    friend Number operator-(const Number& left, const Number& right);
    friend Number operator*(const Number& left, const Number& right);
    /// Returns the quotient. Throws MathError when `right` is zero.
    friend Number operator/(const Number& left, const Number& right);
    friend Number operator-(const Number& argument);

    /// Return an answer that is proved by the normal form when true, and confirmed by an enclosure
    /// when false. They throw MathError when neither can be had ("cannot decide").
    [[nodiscard]] bool is_zero() const;
    [[nodiscard]] bool is_one() const;

    /// Returns whether the number is zero; empty where no normal form proves a zero and an
    /// enclosure of some 150 digits does not tell it from one.
    [[nodiscard]] std::optional<bool> known_zero() const;

    /// Returns -1, 0 or 1. Precondition: no free parameter.
    [[nodiscard]] int sign() const;

    /// Returns whether a free parameter is left, so that there is no decimal value.
    [[nodiscard]] bool has_parameters() const;

    /// Returns the closed form in lowest terms, with a rational denominator where it is algebraic;
    /// empty where there is none.
    [[nodiscard]] std::optional<Expression> closed_form() const;

    /// Returns the closed form as a paper prints a rational function of this parameter: numerator
    /// and denominator written out by its falling powers, `(h^2+6*h+12)/(h^2-6*h+12)`, and a
    /// polynomial by rising ones.
    [[nodiscard]] std::optional<Expression> expanded_form(const std::string& parameter) const;

    /// Returns the value correctly rounded (half to even) to so many significant digits, as
    /// `0.0193...` or `1.93...e-20`. Zero is `0`. A number that no enclosure tells from zero has no
    /// significant digits, and is `0e-50` to 50 of them: zero to so many decimal places, which is
    /// certain. Precondition: no free parameter.
    [[nodiscard]] std::string decimal(int digits) const;

    /// Returns the correctly rounded double. Precondition: no free parameter.
    [[nodiscard]] double nearest_double() const;

    /// Returns the number of so many significant bits that is nearest to the value (half to even),
    /// whatever its exponent. Preconditions: no free parameter; bits <= Dyadic::most_bits.
    [[nodiscard]] Dyadic nearest_of(int bits) const;

    /// Returns the multiple of 2^exponent nearest to the value (half to even). Preconditions: no
    /// free parameter, and the result is a Dyadic.
    [[nodiscard]] Dyadic nearest_multiple(int exponent) const;

    struct Value;  ///< in number_value.hpp, known to generator/exact only
    explicit Number(std::shared_ptr<const Value> value) : value_(std::move(value)) {}
    [[nodiscard]] const Value& value() const { return *value_; }

private:
    std::shared_ptr<const Value> value_;
};

}  // namespace hvi::gen
