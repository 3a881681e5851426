// Exact integers: FLINT's, with value semantics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <flint/fmpz.h>

#include <compare>
#include <string>

namespace hvi::gen {

/// An integer of FLINT.
class Integer {
public:
    Integer() { fmpz_init(value_); }   ///< zero
    Integer(long value) : Integer() {  // NOLINT(google-explicit-constructor): it is an integer
        fmpz_set_si(value_, value);
    }
    Integer(const Integer& other) { fmpz_init_set(value_, other.value_); }
    Integer(Integer&& other) noexcept : Integer() { fmpz_swap(value_, other.value_); }
    Integer& operator=(Integer other) noexcept {
        fmpz_swap(value_, other.value_);
        return *this;
    }
    ~Integer() { fmpz_clear(value_); }

    [[nodiscard]] fmpz* get() { return value_; }
    [[nodiscard]] const fmpz* get() const { return value_; }
    [[nodiscard]] std::string text() const;
    [[nodiscard]] long to_long() const;                                   ///< precondition: it fits
    [[nodiscard]] std::size_t bits() const { return fmpz_bits(value_); }  ///< of its absolute value
    /// Returns whether it is a multiple of `divisor`. Precondition: the divisor is not 0.
    [[nodiscard]] bool is_multiple_of(const Integer& divisor) const {
        return fmpz_divisible(value_, divisor.value_) != 0;
    }

    /// Divides exactly. Precondition: the divisor divides it.
    Integer& operator/=(const Integer& divisor) {
        fmpz_divexact(value_, value_, divisor.value_);
        return *this;
    }
    Integer& operator*=(const Integer& factor) {
        fmpz_mul(value_, value_, factor.value_);
        return *this;
    }
    friend Integer operator*(Integer left, const Integer& right) { return left *= right; }

    friend bool operator==(const Integer& left, const Integer& right) {
        return fmpz_equal(left.value_, right.value_) != 0;
    }
    friend std::strong_ordering operator<=>(const Integer& left, const Integer& right) {
        return fmpz_cmp(left.value_, right.value_) <=> 0;
    }

    /// Returns the least common multiple, which is not negative.
    [[nodiscard]] friend Integer lcm(const Integer& a, const Integer& b) {
        Integer result;
        fmpz_lcm(result.value_, a.value_, b.value_);
        return result;
    }
    /// Returns the remainder from 0 to modulus - 1. Precondition: modulus > 0.
    [[nodiscard]] friend Integer mod(const Integer& integer, const Integer& modulus) {
        Integer result;
        fmpz_mod(result.value_, integer.value_, modulus.value_);
        return result;
    }

private:
    fmpz_t value_;
};

}  // namespace hvi::gen
