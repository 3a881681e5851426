// Functions of numbers of a device, with the same bits on all devices.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/device/real.hpp>
#include <hvi/detail/device/series.hpp>
#include <hvi/detail/device/trigonometry.hpp>

namespace hvi::device {

// NOTE: libraries of functions differ in their last bits. These are made of sums, products, fused
// products and quotients in an order that stands here, and of nothing else. Bounds of their errors
// are in docs/gpu.md, and tests look at them.

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> sqrt(Real<Number> x) {
    return square_root(x.value);
}

// ---- exp and log ----

/// Returns 2^shift exp(x). Precondition: x is not NaN, and |shift| <= 2.
///
/// x = k log(2) + r + c, where k log(2) is taken away in two parts, the first of few bits, so that
/// its product with k is exact; exp(r) = 1 + r + r^2 P(r), where 1 + r is kept in two numbers.
///
/// NOTE: the last sum is rounded by half a unit in the last place; what is added to 1 + r is at
/// most a tenth of it and has three roundings. A result below the normal numbers is rounded once
/// more, to places that are at least twice as large. Together that is less than one unit.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> scaled_exp(Real<Number> x, int shift) {
    using Scalar = Real<Number>;
    const Scalar most = is_single<Number> ? Scalar(90.0) : Scalar(712.0);
    const Scalar least = is_single<Number> ? Scalar(-105.0) : Scalar(-747.0);
    if (x > most) { return infinite<Number>(); }
    if (x < least) { return 0; }
    const Scalar inverse = constant<Scalar>(1.442695f, 0x1.71547652b82fep+0);
    const Scalar log_2 = constant<Scalar>(0x1.62e8p-1f, 0x1.62e42ffp-1);
    const Scalar rest = constant<Scalar>(-0x1.e8082ep-16f, -0x1.718432a1b0e26p-35);
    const auto [k, exponent] = whole_of_product(x, inverse);
    const Scalar far = multiply_add(-k, log_2, x);
    const Scalar near = k * rest;
    const Scalar r = far - near;
    const Scalar c = (far - r) - near;
    const Scalar sum = Scalar(1) + r;
    const Scalar cut_off = (Scalar(1) - sum) + r;
    const Scalar y = sum + (cut_off + multiply_add(r * r, exponential_series(r), c * sum));
    // NOTE: in two factors, as 2^k may be no number where 2^k y is one.
    const int first = (exponent + shift) / 2;
    return (y * power_of_two<Number>(first)) * power_of_two<Number>(exponent + shift - first);
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> exp(Real<Number> x) {
    return x != x ? x : scaled_exp(x, 0);
}

/// x = 2^k (1 + f), and log(1 + f) = 2 artanh(s) for s = f/(2 + f) is f - (f^2/2 - s (f^2/2 + R)).
///
/// NOTE: f is exact; f^2/2 and s (f^2/2 + R) are at most a fifth of f each, with one rounding and
/// four; and a last sum, of which the first part is exact: together less than one unit in the last
/// place.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> log(Real<Number> x) {
    using Scalar = Real<Number>;
    using F = Format<Number>;
    if (x == Scalar(0)) { return -infinite<Number>(); }
    if (!(Scalar(0) < x)) { return not_a_number<Number>(); }
    if (!is_finite(x)) { return x; }
    const bool is_small = x < power_of_two<Number>(F::least);
    const Scalar normal = is_small ? x * power_of_two<Number>(F::fraction) : x;
    // NOTE: 1 + f is between sqrt(1/2) and sqrt(2).
    const auto root = bits_of(constant<Scalar>(0.70710677f, 0x1.6a09e667f3bcdp-1));
    const auto above = bits_of(normal) + (bits_of(Scalar(1)) - root);
    const int k = static_cast<int>(above >> F::fraction) - F::bias;
    constexpr auto mantissa = (typename F::Bits{1} << F::fraction) - 1;
    const Scalar f = number_of<Number>((above & mantissa) + root) - Scalar(1);
    const Scalar s = f / (Scalar(2) + f);
    const Scalar z = s * s;
    const Scalar half_square = Scalar(0.5) * (f * f);
    const Scalar log_2 = constant<Scalar>(0x1.62e8p-1f, 0x1.62e42ffp-1);
    const Scalar rest = constant<Scalar>(-0x1.e8082ep-16f, -0x1.718432a1b0e26p-35);
    const Scalar whole(is_small ? k - F::fraction : k);
    const Scalar behind =
        multiply_add<Number>(s, multiply_add(z, logarithm_series(z), half_square), whole * rest);
    return whole * log_2 - ((half_square - behind) - f);
}

// ---- hyperbolic functions ----

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> magnitude(Real<Number> x) {
    return x < Real<Number>(0) ? -x : x;
}

/// NOTE: half of exp(|x|) is a number where sinh(x) is one. Its error counts one and a sixth times
/// in sinh(x) for |x| > 1, and twice as many units where sinh(x) has smaller places; so sinh is off
/// by less than two units in the last place, cosh as well, and tanh, a quotient of both, by less
/// than three.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> sinh(Real<Number> x) {
    using Scalar = Real<Number>;
    const Scalar size = magnitude(x);
    if (!(Scalar(1) < size)) {
        const Scalar z = x * x;
        return multiply_add(z * hyperbolic_sine_series(z), x, x);
    }
    const Scalar half = scaled_exp(size, -1);
    const Scalar result = half - Scalar(0.25) / half;
    return x < Scalar(0) ? -result : result;
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> cosh(Real<Number> x) {
    using Scalar = Real<Number>;
    if (x != x) { return x; }
    const Scalar half = scaled_exp(magnitude(x), -1);
    return half + Scalar(0.25) / half;
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> tanh(Real<Number> x) {
    using Scalar = Real<Number>;
    const Scalar size = magnitude(x);
    if (!(Scalar(1) < size)) { return x != x ? x : sinh(x) / cosh(x); }
    const Scalar most = is_single<Number> ? Scalar(16.0) : Scalar(32.0);
    const Scalar square = scaled_exp(Scalar(2) * (size < most ? size : most), 0);
    const Scalar result = Scalar(1) - Scalar(2) / (square + Scalar(1));
    return x < Scalar(0) ? -result : result;
}

// ---- kinks and choices; see hvi/detail/numbers/more_math.hpp ----

/// Returns x where a < b, else y: also where a or b is NaN.
template <class Scalar>
[[nodiscard]] HVI_DEVICE constexpr Scalar if_less(Scalar a, Scalar b, Scalar x, Scalar y) {
    return a < b ? x : y;
}

/// Returns x where a <= b, else y: also where a or b is NaN.
template <class Scalar>
[[nodiscard]] HVI_DEVICE constexpr Scalar if_at_most(Scalar a, Scalar b, Scalar x, Scalar y) {
    return a <= b ? x : y;
}

/// Returns the smaller number; NaN where a or b is NaN.
template <class Scalar>
[[nodiscard]] HVI_DEVICE constexpr Scalar min(Scalar a, Scalar b) {
    return a < b ? a : b <= a ? b : a + b;
}

/// Returns the larger number; NaN where a or b is NaN.
template <class Scalar>
[[nodiscard]] HVI_DEVICE constexpr Scalar max(Scalar a, Scalar b) {
    return b < a ? a : a <= b ? b : a + b;
}

template <class Scalar>
[[nodiscard]] HVI_DEVICE constexpr Scalar abs(Scalar x) {
    return Scalar(0) < x ? x : Scalar(0) - x;
}

/// Returns -1, 0 or 1; NaN for NaN.
template <class Scalar>
[[nodiscard]] HVI_DEVICE constexpr Scalar sign(Scalar x) {
    return Scalar(0) < x ? Scalar(1) : x < Scalar(0) ? Scalar(-1) : x - x;
}

}  // namespace hvi::device
