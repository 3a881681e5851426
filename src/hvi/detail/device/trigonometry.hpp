// sin, cos and tan of numbers of a device, with the same bits on all devices.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/device/series.hpp>
#include <hvi/detail/device/sums.hpp>

namespace hvi::device {

/// An angle less a number of quarter turns: r + c, where |r| is at most pi/4 or a little more.
template <class Number>
struct Angle {
    Real<Number> r, c;
    int quarters;  ///< the last bits of their number
};

/// The largest angle that is reduced: 2^30, or 2^20 in float. sin, cos and tan of larger ones are
/// NaN, so that a step that needs them fails.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> most_of_angles() {
    return is_single<Number> ? power_of_two<Number>(20) : power_of_two<Number>(30);
}

/// Reduces an angle by Cody's and Waite's way: n quarter turns are taken away in three parts, each
/// product in two numbers. Precondition: |x| <= most_of_angles().
///
/// NOTE: the three parts have 161 bits of pi/2, or 73 in float. No double of this size, other than
/// 0, is nearer to a multiple of pi/2 than 2^-62, and no float nearer than 2^-30, so that the rest
/// keeps all its bits.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Angle<Number> reduced(Real<Number> x) {
    using Scalar = Real<Number>;
    const Scalar inverse = constant<Scalar>(0.63661975f, 0x1.45f306dc9c883p-1);
    const Scalar first = constant<Scalar>(0x1.921fb6p+0f, 0x1.921fb54442d18p+0);
    const Scalar second = constant<Scalar>(-0x1.777a5cp-25f, 0x1.1a62633145c07p-54);
    const Scalar third = constant<Scalar>(-0x1.ee59dap-50f, -0x1.f1976b7ed8fbcp-110);
    const auto [n, quarters] = whole_of_product(x, inverse);
    // NOTE: this difference is exact, as x and n pi/2 are near each other.
    const Scalar product = n * first;
    const Sum<Number> high = two_sum<Number>(x - product, -multiply_add(n, first, -product));
    const Scalar small = n * second;
    const Sum<Number> low = two_sum<Number>(high.value, -small);
    const Scalar cut_off = multiply_add(-n, third, -multiply_add(n, second, -small));
    const Scalar sum = low.value, rest = (high.remainder + low.remainder) + cut_off;
    const Scalar r = sum + rest;
    return {r, (sum - r) + rest, quarters};
}

/// Return sin(r + c) and cos(r + c) of a reduced angle.
///
/// NOTE: the last sum is rounded by half a unit in the last place. What is added to r, or to 1 less
/// r^2/2, is at most an eighth of the sum, and is made with four roundings or fewer: together less
/// than one unit. tan is a quotient of two of them, rounded once more: less than three.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> sine_of(const Angle<Number>& a) {
    using Scalar = Real<Number>;
    const Scalar z = a.r * a.r;
    const Scalar cube = a.r * (z * sine_series(z));
    return a.r + (cube + multiply_add(Scalar(-0.5) * z, a.c, a.c));
}
template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> cosine_of(const Angle<Number>& a) {
    using Scalar = Real<Number>;
    const Scalar z = a.r * a.r;
    const Scalar half = Scalar(0.5) * z;
    const Scalar sum = Scalar(1) - half;
    const Scalar cut_off = (Scalar(1) - sum) - half;
    return sum + (cut_off + multiply_add(z * z, cosine_series(z), -(a.r * a.c)));
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> sin(Real<Number> x) {
    const Real<Number> most = most_of_angles<Number>();
    if (!(-most <= x && x <= most)) { return not_a_number<Number>(); }
    const Angle<Number> a = reduced(x);
    const Real<Number> result = (a.quarters & 1) != 0 ? cosine_of(a) : sine_of(a);
    return (a.quarters & 2) != 0 ? -result : result;
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> cos(Real<Number> x) {
    const Real<Number> most = most_of_angles<Number>();
    if (!(-most <= x && x <= most)) { return not_a_number<Number>(); }
    const Angle<Number> a = reduced(x);
    const Real<Number> result = (a.quarters & 1) != 0 ? sine_of(a) : cosine_of(a);
    return ((a.quarters + 1) & 2) != 0 ? -result : result;
}

template <class Number>
[[nodiscard]] HVI_DEVICE inline Real<Number> tan(Real<Number> x) {
    const Real<Number> most = most_of_angles<Number>();
    if (!(-most <= x && x <= most)) { return not_a_number<Number>(); }
    const Angle<Number> a = reduced(x);
    return (a.quarters & 1) != 0 ? -(cosine_of(a) / sine_of(a)) : sine_of(a) / cosine_of(a);
}

}  // namespace hvi::device
