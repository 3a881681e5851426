// Functions of small angles, for rotations that are products of shears.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_SMALL_TURNS_HPP
#define HVI_SMALL_TURNS_HPP

#include <cstddef>
#include <type_traits>

#include <hvi/detail/numbers/math.hpp>

namespace hvi::detail {

/// Coefficients in double of tan y = y + y z T(z) and sin 2y = 2y + y z S(z), where z = y^2. The
/// polynomials interpolate in the zeros of Chebyshev's polynomial of z in [0, 1/4]; coefficients
/// were computed to 60 digits and rounded. The relative errors that they make are below 2^-57 and
/// 2^-56.
struct SmallTurn {
    static constexpr double T[] = {
        0x1.5555555555555p-2,  0x1.11111111110a0p-3,  0x1.ba1ba1ba2d324p-5,  0x1.664f487a39af7p-6,
        0x1.226e377ce9975p-7,  0x1.d6d33412afbdap-9,  0x1.7db17680a5a75p-10, 0x1.3489d5fbfa85fp-11,
        0x1.02418b5e02334p-12, 0x1.4156b739a9927p-14, 0x1.26287f4fec261p-14};
    static constexpr double S[] = {
        -0x1.5555555555555p+0,  0x1.11111111110fep-2,  -0x1.a01a01a015353p-6, 0x1.71de3a4e393c6p-10,
        -0x1.ae644c34c0697p-15, 0x1.611cd3538e0b8p-20, -0x1.a8fde98c828f5p-26};
};

/// Returns the largest power of two below n. Precondition: n > 1.
[[nodiscard]] constexpr std::size_t power_below(std::size_t n) {
    std::size_t power = 1;
    while (2 * power < n) { power *= 2; }
    return power;
}

// `Value` is a double, or several.

/// Returns z^n, for a power of two n.
template <std::size_t n, class Value>
[[nodiscard, gnu::always_inline]] inline Value power_of(const Value& z) {
    if constexpr (n == 1) {
        return z;
    } else {
        const Value root = power_of<n / 2>(z);
        return root * root;
    }
}

/// Returns a_0 + a_1 z + ..., of `count` coefficients.
///
/// NOTE: two halves do not wait for each other (Estrin). They are inlined, so that two polynomials
/// share the powers of z.
template <std::size_t count, class Value>
[[nodiscard, gnu::always_inline]] inline Value sum_of_halves(const double* a, const Value& z) {
    if constexpr (count == 1) {
        return a[0];
    } else {
        constexpr std::size_t half = power_below(count);
        return sum_of_halves<half>(a, z) +
               power_of<half>(z) * sum_of_halves<count - half>(a + half, z);
    }
}

template <std::size_t count, class Value>
[[nodiscard, gnu::always_inline]] inline Value polynomial(const double (&a)[count],
                                                          const Value& z) {
    return sum_of_halves<count>(a, z);
}

/// Return tan y and sin 2y. Precondition: |y| <= 1/2.
template <class Value>
[[nodiscard, gnu::always_inline]] inline Value tan_by_polynomial(const Value& y) {
    const Value z = y * y;
    return y + (y * z) * polynomial(SmallTurn::T, z);
}
template <class Value>
[[nodiscard, gnu::always_inline]] inline Value double_sin_by_polynomial(const Value& y) {
    const Value z = y * y;
    return (y + y) + (y * z) * polynomial(SmallTurn::S, z);
}

}  // namespace hvi::detail

namespace hvi::math {

// The shears of a turn by the angle 2y, for |y| <= 1/2: tan y and sin 2y.
//
// NOTE: in double by polynomials, as a turn waits for its angle, and these take less than half of
// the time of the library's functions. What is added to the first term is rounded three times, but
// is a tenth of it at most, or a sixth: errors are below one unit in the last place.

/// Returns tan y. Precondition: |y| <= 1/2.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number small_tan(Number y) {
    if constexpr (std::is_same_v<Number, double>) {
        return detail::tan_by_polynomial(y);
    } else {
        return math::tan(y);
    }
}

/// Returns sin 2y. Precondition: |y| <= 1/2.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number small_double_sin(Number y) {
    if constexpr (std::is_same_v<Number, double>) {
        return detail::double_sin_by_polynomial(y);
    } else {
        return math::sin(y + y);
    }
}

}  // namespace hvi::math

#endif  // HVI_SMALL_TURNS_HPP
