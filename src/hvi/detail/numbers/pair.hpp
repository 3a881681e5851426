// Numbers of twice the digits, and sin, cos and exp of them.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_PAIR_HPP
#define HVI_PAIR_HPP

#include <array>
#include <type_traits>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/numbers/two_product.hpp>

namespace hvi::detail {

/// A constant as the sum of doubles that do not overlap, the largest first: about 260 bits.
using Expansion = std::array<double, 5>;

/// The scalar of the pairs from which a coefficient of another scalar is rounded.
template <class Scalar>
using Work = std::conditional_t<bits<Scalar> == 24, double, Scalar>;

template <class S>
[[nodiscard]] constexpr Pair<S> operator-(const Pair<S>& a) {
    return {-a.hi, -a.lo};
}

/// Returns a + b. The error is below epsilon^2 relative to the sum, also where a and b cancel:
/// algorithm 6 of Joldes, Muller and Popescu, Tight and rigorous error bounds for basic building
/// blocks of double-word arithmetic, ACM Trans. Math. Softw. 44, 2017.
template <class S>
[[nodiscard]] constexpr Pair<S> operator+(const Pair<S>& a, const Pair<S>& b) {
    const Sum<S> high = two_sum(a.hi, b.hi);
    const Sum<S> low = two_sum(a.lo, b.lo);
    const Sum<S> sum = two_sum(high.value, high.remainder + low.value);
    return pair(two_sum(sum.value, low.remainder + sum.remainder));
}

template <class S>
[[nodiscard]] constexpr Pair<S> operator-(const Pair<S>& a, const Pair<S>& b) {
    return a + -b;
}

/// Returns a b to 1.25 epsilon^2: algorithm 10 there.
template <class S>
[[nodiscard]] Pair<S> operator*(const Pair<S>& a, const Pair<S>& b) {
    const Pair<S> high = two_product(a.hi, b.hi);
    const S low = a.hi * b.lo + a.lo * b.hi;
    return pair(two_sum(high.hi, high.lo + low));
}

/// Returns a / b to 4 epsilon^2.
template <class S>
[[nodiscard]] Pair<S> operator/(const Pair<S>& a, const Pair<S>& b) {
    const S quotient = a.hi / b.hi;
    const Pair<S> rest = a - b * Pair<S>{quotient};
    return pair(two_sum(quotient, rest.hi / b.hi));
}

template <class S>
[[nodiscard]] constexpr bool is_zero(const Pair<S>& a) {
    return a.hi == 0;
}

/// Returns a^exponent.
template <class S>
[[nodiscard]] Pair<S> power(const Pair<S>& a, int exponent) {
    Pair<S> result{S(1)};
    for (; exponent > 0; --exponent) { result = result * a; }
    return result;
}

template <class S>
[[nodiscard]] constexpr Pair<S> to_pair(const Expansion& parts) {
    Pair<S> sum;
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        sum = sum + Pair<S>{static_cast<S>(*part)};
    }
    return sum;
}

/// Returns the nearest number.
template <class Scalar>
[[nodiscard]] constexpr Scalar to_scalar(const Pair<Work<Scalar>>& a) {
    return static_cast<Scalar>(a.hi);
}

/// An argument divided by a period: argument == multiple * period + rest.
template <class S>
struct Reduced {
    long long multiple;
    Pair<S> rest;
};

/// Divides an argument by a period. The rest is at most about half a period, and right to
/// epsilon^2, absolutely. Precondition: |argument| <= 2^22.
///
/// NOTE: the multiple has 23 bits, so that its products with the parts of the period are exact. So
/// far from 0 the rest keeps digits that it would lose with a rounded period.
template <class S>
[[nodiscard]] Reduced<S> reduce(const Pair<S>& argument, const Expansion& period) {
    const S quotient = argument.hi / static_cast<S>(period[0]);
    const S half = S(1) / 2;
    const auto multiple = static_cast<long long>(quotient < 0 ? quotient - half : quotient + half);
    Pair<S> rest = argument;
    for (const double part : period) {
        rest = rest - two_product(static_cast<S>(multiple), static_cast<S>(part));
    }
    return {multiple, rest};
}

/// Returns whether a term of a series still counts beside another one, so that the terms after it
/// may.
template <class S>
[[nodiscard]] bool counts(const Pair<S>& term, const Pair<S>& beside) {
    constexpr S negligible = epsilon<S> * epsilon<S> / 64;
    return abs(term.hi) > negligible * abs(beside.hi);
}

template <class S>
struct SinCos {
    Pair<S> sin;
    Pair<S> cos;
};

/// Returns sin and cos. Precondition: |angle| <= 2^22.
template <class S>
[[nodiscard]] SinCos<S> sin_cos(const Pair<S>& angle) {
    constexpr Expansion quarter_turn{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
                                     -0x1.f1976b7ed8fbcp-110, 0x1.4cf98e804177dp-164,
                                     0x1.31d89cd9128a5p-218};
    const auto [quarter_turns, rest] = reduce(angle, quarter_turn);
    Pair<S> sin = rest;
    Pair<S> cos{S(1)};
    Pair<S> term = rest;
    for (int n = 2; counts(term, rest); ++n) {
        term = term * rest / Pair<S>{S(n)};
        Pair<S>& sum = n % 2 == 0 ? cos : sin;
        sum = sum + (n % 4 < 2 ? term : -term);
    }
    switch (quarter_turns % 4) {
    case 0: return {sin, cos};
    case 1:
    case -3: return {cos, -sin};
    case 2:
    case -2: return {-sin, -cos};
    default: return {-cos, sin};
    }
}

/// Returns 2^exponent, or infinity, or 0.
template <class S>
[[nodiscard]] S two_to_the(long long exponent) {
    S base = exponent < 0 ? S(1) / 2 : S(2);
    S result = 1;
    for (; exponent != 0; exponent /= 2) {
        if (exponent % 2 != 0) { result *= base; }
        base *= base;
    }
    return result;
}

/// Returns exp(exponent). Precondition: exponent <= 2^22.
template <class S>
[[nodiscard]] Pair<S> exp(const Pair<S>& exponent) {
    constexpr Expansion ln_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56, 0x1.7b57a079a1934p-111,
                             -0x1.ace93a4ebe5d1p-165, -0x1.23a2a82ea0c24p-219};
    if (exponent.hi < -16384) { return {}; }  // NOTE: 0 in any format
    const auto [doublings, rest] = reduce(exponent, ln_2);
    Pair<S> sum{S(1)};
    Pair<S> term{S(1)};
    for (int n = 1; counts(term, Pair<S>{S(1)}); ++n) {
        term = term * rest / Pair<S>{S(n)};
        sum = sum + term;
    }
    // NOTE: in two steps, as 2^1024 is no double where half of it times 2^1023 is one.
    const S first = two_to_the<S>(doublings / 2);
    const S second = two_to_the<S>(doublings - doublings / 2);
    return {sum.hi * first * second, sum.lo * first * second};
}

}  // namespace hvi::detail

#endif  // HVI_PAIR_HPP
