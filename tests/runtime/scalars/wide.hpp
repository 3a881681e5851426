// Exact arithmetic, which shares nothing with the generator's, to judge roundings by.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace scalars {

/// A multiple of 2^-256 below 2^63 in absolute value, in two's complement, the last digits first.
class Wide {
public:
    Wide() = default;

    /// From `-1.25`, with an error below 2^-255.
    explicit Wide(const std::string& decimal) {
        const bool negative = decimal.front() == '-';
        const std::size_t point = decimal.find('.');
        for (std::size_t i = decimal.size() - 1; i > point; --i) {
            *this = over_ten(*this + digit(decimal[i]));
        }
        Wide whole;
        for (std::size_t i = negative ? 1 : 0; i < point; ++i) {
            whole = whole * digit('9') + whole + digit(decimal[i]);
        }
        *this = negative ? Wide() - (*this + whole) : *this + whole;
    }

    /// Exactly. Precondition: |value| < 2^32, and no bit below 2^-256.
    template <class Scalar>
    static Wide of(Scalar value) {
        const bool negative = value < 0;
        if (negative) { value = -value; }
        Wide result;
        for (std::size_t i = fraction; value != 0; --i) {
            result.limbs_[i] = static_cast<std::uint32_t>(value);
            value -= static_cast<Scalar>(result.limbs_[i]);
            value *= 65536;
            value *= 65536;
            if (i == 0) { break; }
        }
        return negative ? Wide() - result : result;
    }

    friend Wide operator+(const Wide& a, const Wide& b) {
        Wide sum;
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < size; ++i) {
            carry += std::uint64_t{a.limbs_[i]} + b.limbs_[i];
            sum.limbs_[i] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        return sum;
    }
    friend Wide operator-(const Wide& a, const Wide& b) {
        Wide complement;
        for (std::size_t i = 0; i < size; ++i) { complement.limbs_[i] = ~b.limbs_[i]; }
        Wide last;
        last.limbs_[0] = 1;
        return a + (complement + last);
    }
    /// Cut off below 2^-256.
    friend Wide operator*(const Wide& a, const Wide& b) {
        const Wide x = a.absolute();
        const Wide y = b.absolute();
        std::array<std::uint32_t, 2 * size> product{};
        for (std::size_t i = 0; i < size; ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < size; ++j) {
                carry += std::uint64_t{x.limbs_[i]} * y.limbs_[j] + product[i + j];
                product[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            product[i + size] = static_cast<std::uint32_t>(carry);
        }
        Wide result;
        for (std::size_t i = 0; i < size; ++i) { result.limbs_[i] = product[i + fraction]; }
        return a.is_negative() == b.is_negative() ? result : Wide() - result;
    }
    friend bool operator<=(const Wide& a, const Wide& b) { return !(b - a).is_negative(); }

    [[nodiscard]] bool is_negative() const { return limbs_.back() >> 31 != 0; }
    [[nodiscard]] Wide absolute() const { return is_negative() ? Wide() - *this : *this; }

private:
    static constexpr std::size_t fraction = 8;
    static constexpr std::size_t size = fraction + 2;

    static Wide digit(char c) {
        Wide result;
        result.limbs_[fraction] = static_cast<std::uint32_t>(c - '0');
        return result;
    }
    static Wide over_ten(const Wide& value) {
        Wide quotient;
        std::uint64_t rest = 0;
        for (std::size_t i = size; i-- > 0;) {
            rest = (rest << 32) + value.limbs_[i];
            quotient.limbs_[i] = static_cast<std::uint32_t>(rest / 10);
            rest %= 10;
        }
        return quotient;
    }

    std::array<std::uint32_t, size> limbs_{};
};

}  // namespace scalars
