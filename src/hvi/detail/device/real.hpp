// Numbers of a device, whose bits do not depend on the compiler.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include <hvi/detail/device/device.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::device {

template <class Number>
inline constexpr bool computes_in = std::is_same_v<Number, float> || std::is_same_v<Number, double>;

/// A number, each operation of which is rounded for itself: products stay products, and are fused
/// with sums only by multiply_add(), where that is written.
template <class Number>
struct Real {
    Number value = 0;

    Real() = default;
    HVI_DEVICE constexpr Real(Number x) : value(x) {}
    template <class Other, class = std::enable_if_t<std::is_arithmetic_v<Other> &&
                                                    !std::is_same_v<Other, Number>>>
    HVI_DEVICE constexpr explicit Real(Other x) : value(static_cast<Number>(x)) {}

    HVI_DEVICE constexpr explicit operator Number() const { return value; }

    [[nodiscard]] HVI_DEVICE friend constexpr Real operator-(Real a) { return -a.value; }
    [[nodiscard]] HVI_DEVICE friend constexpr Real operator+(Real a, Real b) {
        return a.value + b.value;
    }
    [[nodiscard]] HVI_DEVICE friend constexpr Real operator-(Real a, Real b) {
        return a.value - b.value;
    }
    [[nodiscard]] HVI_DEVICE friend Real operator*(Real a, Real b) {
        return product(a.value, b.value);
    }
    [[nodiscard]] HVI_DEVICE friend Real operator/(Real a, Real b) {
        return quotient(a.value, b.value);
    }
    HVI_DEVICE constexpr Real& operator+=(Real b) { return *this = *this + b; }
    HVI_DEVICE constexpr Real& operator-=(Real b) { return *this = *this - b; }

    [[nodiscard]] HVI_DEVICE friend constexpr bool operator==(Real a, Real b) {
        return a.value == b.value;
    }
    [[nodiscard]] HVI_DEVICE friend constexpr bool operator!=(Real a, Real b) {
        return a.value != b.value;
    }
    [[nodiscard]] HVI_DEVICE friend constexpr bool operator<(Real a, Real b) {
        return a.value < b.value;
    }
    [[nodiscard]] HVI_DEVICE friend constexpr bool operator<=(Real a, Real b) {
        return a.value <= b.value;
    }
    [[nodiscard]] HVI_DEVICE friend constexpr bool operator>(Real a, Real b) {
        return a.value > b.value;
    }
};

/// Returns a b + c, rounded once.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> multiply_add(Real<Number> a, Real<Number> b,
                                                          Real<Number> c) {
    return fused(a.value, b.value, c.value);
}

/// Returns a constant that is rounded to each format on its own.
template <class Scalar>
[[nodiscard]] HVI_DEVICE constexpr Scalar constant(float single, double twice) {
    return sizeof(Scalar) == sizeof(float) ? Scalar(single) : Scalar(twice);
}

/// Returns whether x is neither infinite nor NaN.
template <class Number>
[[nodiscard]] HVI_DEVICE constexpr bool is_finite(Real<Number> x) {
    return x - x == Real<Number>(0);
}

/// Numbers in a row, on the host and on devices. NOTE: the members of std::array are functions of
/// the host.
template <class Number, std::size_t n>
struct Vector {
    Number numbers[n > 0 ? n : 1];

    [[nodiscard]] HVI_DEVICE constexpr Number& operator[](std::size_t k) { return numbers[k]; }
    [[nodiscard]] HVI_DEVICE constexpr const Number& operator[](std::size_t k) const {
        return numbers[k];
    }
    [[nodiscard]] HVI_DEVICE static constexpr std::size_t size() { return n; }
};

template <class Number, std::size_t n>
[[nodiscard]] HVI_DEVICE constexpr Vector<Real<Number>, n> load(const Vector<Number, n>& from) {
    Vector<Real<Number>, n> values{};
    for (std::size_t k = 0; k < n; ++k) { values[k] = from[k]; }
    return values;
}

template <class Number, std::size_t n>
HVI_DEVICE constexpr void store(const Vector<Real<Number>, n>& values, Vector<Number, n>& to) {
    for (std::size_t k = 0; k < n; ++k) { to[k] = values[k].value; }
}

}  // namespace hvi::device
