// Exact rationals: FLINT's, with value semantics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <flint/fmpq.h>

#include <compare>
#include <string>

#include "generator/exact/numbers/integers.hpp"

namespace hvi::gen {

/// A rational of FLINT: in lowest terms, the denominator positive.
class Rational {
public:
    Rational() { fmpq_init(value_); }    ///< zero
    Rational(long value) : Rational() {  // NOLINT(google-explicit-constructor): it is a rational
        fmpq_set_si(value_, value, 1);
    }
    Rational(const Integer& value) : Rational() {  // NOLINT(google-explicit-constructor): as above
        fmpz_set(fmpq_numref(value_), value.get());
    }
    Rational(const Rational& other) : Rational() { fmpq_set(value_, other.value_); }
    Rational(Rational&& other) noexcept : Rational() { fmpq_swap(value_, other.value_); }
    Rational& operator=(Rational other) noexcept {
        fmpq_swap(value_, other.value_);
        return *this;
    }
    ~Rational() { fmpq_clear(value_); }

    /// Reads a text as `7` or `-2/3`.
    [[nodiscard]] static Rational read(const std::string& text);

    [[nodiscard]] fmpq* get() { return value_; }
    [[nodiscard]] const fmpq* get() const { return value_; }
    [[nodiscard]] std::string text() const;  ///< as `7` or `-2/3`
    [[nodiscard]] Integer numerator() const;
    [[nodiscard]] Integer denominator() const;
    [[nodiscard]] bool is_integer() const { return fmpz_is_one(fmpq_denref(value_)) != 0; }
    [[nodiscard]] bool is_zero() const { return fmpq_is_zero(value_) != 0; }
    [[nodiscard]] int sign() const { return fmpq_sgn(value_); }
    [[nodiscard]] long to_long() const;  ///< precondition: it is an integer that fits

    Rational& operator+=(const Rational& other) {
        fmpq_add(value_, value_, other.value_);
        return *this;
    }
    Rational& operator*=(const Rational& other) {
        fmpq_mul(value_, value_, other.value_);
        return *this;
    }
    Rational& operator/=(const Rational& divisor);  ///< precondition: not by zero
    friend Rational operator-(Rational argument) {
        fmpq_neg(argument.value_, argument.value_);
        return argument;
    }
    friend Rational operator-(Rational left, const Rational& right) {
        fmpq_sub(left.value_, left.value_, right.value_);
        return left;
    }
    friend Rational operator*(Rational left, const Rational& right) { return left *= right; }
    friend Rational operator/(Rational left, const Rational& right) { return left /= right; }

    friend bool operator==(const Rational& left, const Rational& right) {
        return fmpq_equal(left.value_, right.value_) != 0;
    }
    friend std::strong_ordering operator<=>(const Rational& left, const Rational& right) {
        return fmpq_cmp(left.value_, right.value_) <=> 0;
    }

    [[nodiscard]] friend Rational abs(Rational argument) {
        fmpq_abs(argument.value_, argument.value_);
        return argument;
    }
    /// Returns the largest rational of which both are multiples by integers; not negative.
    [[nodiscard]] friend Rational gcd(const Rational& a, const Rational& b) {
        Rational result;
        fmpq_gcd(result.value_, a.value_, b.value_);
        return result;
    }
    /// Returns base^exponent. Precondition: the base is not zero.
    [[nodiscard]] friend Rational power(const Rational& base, long exponent) {
        Rational result;
        fmpq_pow_si(result.value_, base.value_, exponent);
        return result;
    }

private:
    fmpq_t value_;
};

}  // namespace hvi::gen
