// Polynomials for functions of a device, and the bits of numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>

#include <hvi/detail/device/real.hpp>

namespace hvi::device {

// The polynomials interpolate the functions in the zeros of Chebyshev's polynomials of the interval
// that stands beside them; coefficients were computed to 60 digits and rounded. What stands behind
// "to" bounds the error of the function relative to its value, in a real number's arithmetic.

template <class Number>
inline constexpr bool is_single = std::is_same_v<Number, float>;

/// Returns c_0 + x (c_1 + x (c_2 + ...)).
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> horner(Real<Number>, Number last) {
    return last;
}
template <class Number, class... Rest>
[[nodiscard]] HVI_DEVICE inline Real<Number> horner(Real<Number> x, Number first, Rest... rest) {
    return multiply_add<Number>(horner(x, rest...), x, first);
}

/// Returns (sin(r)/r - 1)/r^2 for z = r^2 <= 0.64: to 2^-35 and 2^-66.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> sine_series(Real<Number> z) {
    if constexpr (is_single<Number>) {
        return horner(z, -0.16666667f, 0.008333332f, -0.00019839997f, 2.7238455e-06f);
    } else {
        return horner(z, -0x1.5555555555555p-3, 0x1.111111111111p-7, -0x1.a01a01a0197d4p-13,
                      0x1.71de3a54361f8p-19, -0x1.ae6453ca65b3dp-26, 0x1.612146c012422p-33,
                      -0x1.aaf7413aa6338p-41);
    }
}

/// Returns (cos(r) - 1 + r^2/2)/r^4 for z = r^2 <= 0.64: to 2^-39 and 2^-60.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> cosine_series(Real<Number> z) {
    if constexpr (is_single<Number>) {
        return horner(z, 0.041666668f, -0.0013888888f, 2.4800525e-05f, -2.7291384e-07f);
    } else {
        return horner(z, 0x1.5555555555555p-5, -0x1.6c16c16c168dcp-10, 0x1.a01a019f2e74fp-16,
                      -0x1.27e4f9eed5802p-22, 0x1.1eeb3ef5846aap-29, -0x1.905ff8538dfd9p-37);
    }
}

/// Returns (exp(r) - 1 - r)/r^2 for |r| <= 0.3475: to 2^-31 and 2^-61.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> exponential_series(Real<Number> r) {
    if constexpr (is_single<Number>) {
        return horner(r, 0.5f, 0.16666667f, 0.041666463f, 0.0083333105f, 0.0013933881f,
                      0.00019891247f);
    } else {
        return horner(r, 0.5, 0x1.5555555555557p-3, 0x1.5555555555556p-5, 0x1.1111111110085p-7,
                      0x1.6c16c16c162a3p-10, 0x1.a01a01ac16f76p-13, 0x1.a01a01a6f35fbp-16,
                      0x1.71de019d031e7p-19, 0x1.27e4db0f8a3efp-22, 0x1.af4f1ddf981a8p-26,
                      0x1.1f73b376c0f55p-29);
    }
}

/// Returns (2 artanh(s)/s - 2)/s^2 for z = s^2 <= 0.0295: to 2^-35 and 2^-62.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> logarithm_series(Real<Number> z) {
    if constexpr (is_single<Number>) {
        return horner(z, 0.6666667f, 0.40000123f, 0.28550732f, 0.23332913f);
    } else {
        return horner(z, 0x1.5555555555555p-1, 0x1.9999999999a3ap-2, 0x1.249249247670ap-2,
                      0x1.c71c7201fc0e6p-3, 0x1.745cf8c09a9d4p-3, 0x1.3b1c43c68eb6dp-3,
                      0x1.0fbd140544b63p-3, 0x1.0c135adcf3011p-3);
    }
}

/// Returns (sinh(x)/x - 1)/x^2 for z = x^2 <= 1: to 2^-32 and 2^-71.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> hyperbolic_sine_series(Real<Number> z) {
    if constexpr (is_single<Number>) {
        return horner(z, 0.16666667f, 0.008333339f, 0.00019838102f, 2.8062803e-06f);
    } else {
        return horner(z, 0x1.5555555555555p-3, 0x1.1111111111111p-7, 0x1.a01a01a01a001p-13,
                      0x1.71de3a556f96cp-19, 0x1.ae6456792a77fp-26, 0x1.612467ccb2260p-33,
                      0x1.ae777c36fd5b6p-41, 0x1.99f0806c2628dp-49);
    }
}

// ---- bits ----

/// Parameters of a format.
template <class Number>
struct Format {
    using Bits = std::uint64_t;
    static constexpr int fraction = 52, bias = 1023, least = -1022;
};
template <>
struct Format<float> {
    using Bits = std::uint32_t;
    static constexpr int fraction = 23, bias = 127, least = -126;
};

template <class Number>
[[nodiscard]] HVI_DEVICE inline typename Format<Number>::Bits bits_of(Real<Number> x) {
    typename Format<Number>::Bits bits;
    __builtin_memcpy(&bits, &x.value, sizeof bits);
    return bits;
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> number_of(typename Format<Number>::Bits bits) {
    Number x;
    __builtin_memcpy(&x, &bits, sizeof x);
    return x;
}

/// Returns 2^exponent. Precondition: that is a normal number.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> power_of_two(int exponent) {
    using F = Format<Number>;
    return number_of<Number>(static_cast<typename F::Bits>(exponent + F::bias) << F::fraction);
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> not_a_number() {
    return number_of<Number>(static_cast<typename Format<Number>::Bits>(
        (typename Format<Number>::Bits{1} << (sizeof(Number) * 8 - 1)) -
        (typename Format<Number>::Bits{1} << (Format<Number>::fraction - 1))));
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> infinite() {
    return number_of<Number>(static_cast<typename Format<Number>::Bits>(
        (typename Format<Number>::Bits{1} << (sizeof(Number) * 8 - 1)) -
        (typename Format<Number>::Bits{1} << Format<Number>::fraction)));
}

/// A number near a whole one, and the whole one.
template <class Number>
struct Whole {
    Real<Number> value;
    int low;  ///< its last bits, with its sign where it is small
};

/// Returns a b rounded to a whole number. Precondition: |a b| is below 2^50, or 2^21 in float.
///
/// NOTE: a sum with 1.5 times the number whose last place is 1 rounds so on every processor.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Whole<Number> whole_of_product(Real<Number> a, Real<Number> b) {
    using F = Format<Number>;
    const Real<Number> large =
        power_of_two<Number>(F::fraction) + power_of_two<Number>(F::fraction - 1);
    const Real<Number> sum = multiply_add(a, b, large);
    const auto last = static_cast<typename F::Bits>(bits_of(sum) - bits_of(large));
    return {sum - large, static_cast<int>(static_cast<std::uint32_t>(last))};
}

}  // namespace hvi::device
