// sin, cos and tan of several numbers at once.
// SPDX-License-Identifier: MIT
//
// NOTE: those of xsimd take another way to the quadrant where all numbers of a register are small,
// and round differently there: what becomes of a number depends on its neighbours. These do not.
#pragma once

#include <cmath>
#include <cstddef>

#include <hvi/detail/lanes/registers.hpp>
#include <hvi/detail/numbers/math.hpp>

namespace hvi::detail {

/// Of one number.
template <class Number>
[[nodiscard]] Number sin_of(const Number& x) {
    return math::sin(x);
}
template <class Number>
[[nodiscard]] Number cos_of(const Number& x) {
    return math::cos(x);
}
template <class Number>
[[nodiscard]] Number tan_of(const Number& x) {
    return math::tan(x);
}

#if HVI_REGISTER_BYTES

/// pi/2 in three parts, the first two of so few bits that products with small integers are exact,
/// and sin r = r + r^3 S(r^2), cos r = 1 - r^2/2 + r^4 C(r^2) for |r| <= pi/4.
template <class Number>
struct Trigonometry;

/// The coefficients are those of fdlibm (Sun Microsystems, 1993).
template <>
struct Trigonometry<double> {
    static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
    static constexpr double half_pi[] = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
    static constexpr double to_integer = 0x1.8p52;  ///< x + this - this is an integer
    static constexpr double largest = 524288;       ///< of which the products are exact
    static constexpr double S[] = {-0x1.5555555555549p-3,  0x1.111111110f8a6p-7,
                                   -0x1.a01a019c161d5p-13, 0x1.71de357b1fe7dp-19,
                                   -0x1.ae5e68a2b9cebp-26, 0x1.5d93a5acfd57cp-33};
    static constexpr double C[] = {0x1.555555555554cp-5,  -0x1.6c16c16c15177p-10,
                                   0x1.a01a019cb159p-16,  -0x1.27e4f809c52adp-22,
                                   0x1.1ee9ebdb4b1c4p-29, -0x1.8fae9be8838d4p-37};
};

/// Those of Cephes (Moshier).
template <>
struct Trigonometry<float> {
    static constexpr float two_over_pi = 0x1.45f306p-1F;
    static constexpr float half_pi[] = {1.5703125F, 4.837512969970703125e-4F,
                                        7.54978995489188216e-8F};
    static constexpr float to_integer = 0x1.8p23F;
    static constexpr float largest = 4096;
    static constexpr float S[] = {-1.6666654611e-1F, 8.3321608736e-3F, -1.9515295891e-4F};
    static constexpr float C[] = {4.166664568298827e-2F, -1.388731625493765e-3F,
                                  2.443315711809948e-5F};
};

/// sin x and cos x where |x| is not large.
///
/// NOTE: inlined, as no register of this size lives through a call.
template <class Part>
struct RegisterSinCos {
    Part sin, cos;

    [[gnu::always_inline]] inline explicit RegisterSinCos(const Part& x) {
        // NOTE: n = round(2 x/pi) = 2 m + o with o = -1, 0 or 1, all as numbers: sin(r + n pi/2) is
        // sin r or o cos r, and changes its sign where m is odd.
        const Part half(static_cast<Number>(0.5));
        const Part n = integer(x * Part(Table::two_over_pi));
        const Part m = integer(n * half);
        const Part o = n - (m + m);
        const Part half_m = integer(m * half);
        const Part odd = m - (half_m + half_m);
        const Part sign = Part(1) - (odd * odd + odd * odd);

        const Part r = ((x - n * Part(Table::half_pi[0])) - n * Part(Table::half_pi[1])) -
                       n * Part(Table::half_pi[2]);
        const Part z = r * r;
        const Part s = r + (r * z) * polynomial(Table::S, z);
        const Part c = Part(1) - (half * z - (z * z) * polynomial(Table::C, z));

        const auto is_even = o == Part(0);
        sin = sign * select(is_even, s, o * c);
        cos = sign * select(is_even, c, -(o * s));
    }

private:
    using Number = typename Part::value_type;
    using Table = Trigonometry<Number>;

    [[nodiscard]] static Part integer(const Part& x) {
        return (x + Part(Table::to_integer)) - Part(Table::to_integer);
    }

    template <std::size_t n>
    [[nodiscard]] static Part polynomial(const Number (&coefficients)[n], const Part& z) {
        Part value(coefficients[n - 1]);
        for (std::size_t i = n - 1; i > 0; --i) { value = value * z + Part(coefficients[i - 1]); }
        return value;
    }
};

/// NOTE: not inlined, as what is seldom computed takes registers from what is.
template <class Number, std::size_t width, class F>
[[nodiscard, gnu::noinline, gnu::cold]] PackedNumbers<Number, width>
one_by_one(const PackedNumbers<Number, width>& x, F f) {
    return each_of(x, f);
}

/// `values`, and f(x), number by number, where |x| is large.
template <class Number, std::size_t width, class F>
[[nodiscard, gnu::always_inline]] inline PackedNumbers<Number, width>
with_large(const PackedNumbers<Number, width>& x, const PackedNumbers<Number, width>& values, F f) {
    using Part = PackedNumbers<Number, width>;
    const auto is_large = Part(Trigonometry<Number>::largest) < abs(x);
    return any(is_large) ? select(is_large, one_by_one(x, f), values) : values;
}

template <class Number, std::size_t width>
[[nodiscard, gnu::always_inline]] inline PackedNumbers<Number, width>
sin_of(const PackedNumbers<Number, width>& x) {
    using Part = PackedNumbers<Number, width>;
    return with_large(x, RegisterSinCos<Part>(x).sin, [](Number a) { return std::sin(a); });
}

template <class Number, std::size_t width>
[[nodiscard, gnu::always_inline]] inline PackedNumbers<Number, width>
cos_of(const PackedNumbers<Number, width>& x) {
    using Part = PackedNumbers<Number, width>;
    return with_large(x, RegisterSinCos<Part>(x).cos, [](Number a) { return std::cos(a); });
}

template <class Number, std::size_t width>
[[nodiscard, gnu::always_inline]] inline PackedNumbers<Number, width>
tan_of(const PackedNumbers<Number, width>& x) {
    using Part = PackedNumbers<Number, width>;
    const RegisterSinCos<Part> both(x);
    return with_large(x, both.sin / both.cos, [](Number a) { return std::tan(a); });
}

#endif

}  // namespace hvi::detail
