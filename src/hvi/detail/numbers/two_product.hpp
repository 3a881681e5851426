// Products that keep what rounding cuts off.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_TWO_PRODUCT_HPP
#define HVI_TWO_PRODUCT_HPP

#include <cmath>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// A number hi + lo, where |lo| is at most half a unit in the last place of hi.
template <class S>
struct Pair {
    S hi{};
    S lo{};
};

template <class S>
[[nodiscard]] constexpr Pair<S> pair(const Sum<S>& sum) {
    return {sum.value, sum.remainder};
}

/// Whether the processor multiplies and adds in one instruction, as the compiler is told.
#if defined(__FP_FAST_FMA) || defined(__FMA__)
inline constexpr bool has_fused_instruction = true;
#else
inline constexpr bool has_fused_instruction = false;
#endif

/// Returns x such that the compiler no longer knows that it was a product.
///
/// NOTE: where one instruction multiplies and adds, a compiler may leave out the rounding between.
/// opaque() is called on a product where later sums rely on its rounding. x86 without FMA is known
/// to have no such instruction.
template <class S>
[[nodiscard]] S opaque(S x) {
#if defined(__x86_64__) && !defined(__FMA__)
    return x;
#else
    const volatile S copy = x;
    return copy;
#endif
}

/// Returns a as hi + lo; products of such halves are exact (Veltkamp).
template <class S>
[[nodiscard]] Pair<S> halves(S a) {
    constexpr S factor = 1 / power_of_two<S>(-(bits<S> + 1) / 2) + 1;
    const S scaled = opaque(factor * a);
    const S hi = scaled - (scaled - a);
    return {hi, a - hi};
}

/// Returns a * b as hi + lo, by one instruction or by halves (Dekker), to the same bits.
/// Precondition: neither overflow nor underflow, also of a and b times 2^57.
template <class S>
[[nodiscard]] Pair<S> two_product(S a, S b) {
    if constexpr (is_standard<S> && bits<S> <= 53 && has_fused_instruction) {
        const S product = a * b;
        return {product, std::fma(a, b, -product)};
    } else {
        const S product = opaque(a * b);
        const Pair<S> x = halves(a);
        const Pair<S> y = halves(b);
        return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
    }
}

}  // namespace hvi::detail

#endif  // HVI_TWO_PRODUCT_HPP
