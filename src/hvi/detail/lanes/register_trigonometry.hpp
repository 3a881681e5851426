// sin, cos and tan of several numbers at once.
// SPDX-License-Identifier: MIT
//
// NOTE: sin and cos of xsimd reduce the angle in another way where all numbers of a register are
// small, and round differently there, so that the result for a number depends on its neighbours.
// The functions below do not.
#pragma once

#include <cmath>
#include <cstddef>

#include <hvi/detail/lanes/registers.hpp>
#include <hvi/detail/numbers/math.hpp>

namespace hvi::detail {

/// Returns sin, cos or tan of one number.
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

/// Constants: pi/2 in three parts, the first two of so few bits that products with small integers
/// are exact, and the polynomials of sin r = r + r^3 S(r^2), cos r = 1 - r^2/2 + r^4 C(r^2) for |r|
/// <= pi/4.
template <class Number>
struct Trigonometry;

/// Coefficients of fdlibm (Sun Microsystems, 1993).
template <>
struct Trigonometry<double> {
    static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
    static constexpr double half_pi[] = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
    static constexpr double to_integer = 0x1.8p52;  ///< x + to_integer - to_integer is an integer
    static constexpr double largest = 524288;       ///< largest |x| with exact products
    static constexpr double S[] = {-0x1.5555555555549p-3,  0x1.111111110f8a6p-7,
                                   -0x1.a01a019c161d5p-13, 0x1.71de357b1fe7dp-19,
                                   -0x1.ae5e68a2b9cebp-26, 0x1.5d93a5acfd57cp-33};
    static constexpr double C[] = {0x1.555555555554cp-5,  -0x1.6c16c16c15177p-10,
                                   0x1.a01a019cb159p-16,  -0x1.27e4f809c52adp-22,
                                   0x1.1ee9ebdb4b1c4p-29, -0x1.8fae9be8838d4p-37};
};

/// Coefficients of Cephes (Moshier).
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
/// NOTE: inlined, as no register of this size lives through a call. Compilers then drop the part of
/// the result that the caller does not use.
template <class Part>
struct RegisterSinCos {
    Part sin, cos;

    [[gnu::always_inline]] inline explicit RegisterSinCos(const Part& x) {
        // NOTE: n = round(2 x/pi) is in the last bits of x 2/pi + to_integer.
        const Part shifted = x * Part(Table::two_over_pi) + Part(Table::to_integer);
        const Part n = shifted - Part(Table::to_integer);
        const Part r = ((x - n * Part(Table::half_pi[0])) - n * Part(Table::half_pi[1])) -
                       n * Part(Table::half_pi[2]);
        const Part z = r * r, zz = z * z;
        const Part s = r + (r * z) * polynomial(Table::S, z, zz);
        const Part c =
            Part(1) - (Part(static_cast<Number>(0.5)) * z - zz * polynomial(Table::C, z, zz));

        // sin(r + n pi/2) is sin r, cos r, -sin r, -cos r for n = 0, 1, 2, 3, and so on.
        const Bits quadrant = Bits(shifted.vector);
        const typename Part::Mask is_odd(-(quadrant & 1));
        sin = changed_in_sign(select(is_odd, c, s), quadrant);
        cos = changed_in_sign(select(is_odd, s, c), quadrant + 1);
    }

private:
    using Number = typename Part::value_type;
    using Bits = typename Part::Bits;
    using Table = Trigonometry<Number>;
    static constexpr int to_sign = 8 * sizeof(Number) - 2;  ///< from the last bit but one

    /// Returns x with its sign changed where the last bit but one is set.
    [[nodiscard]] static Part changed_in_sign(const Part& x, const Bits& bits) {
        using Vector = typename Part::Vector;
        return Vector(Bits(x.vector) ^ ((bits & 2) << to_sign));
    }

    /// Returns sum a_i z^i. NOTE: in pairs, which do not wait for each other.
    template <std::size_t n>
    [[nodiscard]] static Part polynomial(const Number (&a)[n], const Part& z, const Part& zz) {
        constexpr std::size_t last = (n - 1) / 2 * 2;
        Part value(a[last]);
        if constexpr (n % 2 == 0) { value = value + Part(a[last + 1]) * z; }
        for (std::size_t i = last; i > 0; i -= 2) {
            value = value * zz + (Part(a[i - 2]) + Part(a[i - 1]) * z);
        }
        return value;
    }
};

/// Applies f number by number. NOTE: not inlined, as this rare case would take registers from the
/// common one.
template <class Number, std::size_t width, class F>
[[nodiscard, gnu::noinline, gnu::cold]] PackedNumbers<Number, width>
one_by_one(const PackedNumbers<Number, width>& x, F f) {
    return each_of(x, f);
}

/// Returns `values`, but f(x) number by number where |x| is large.
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
