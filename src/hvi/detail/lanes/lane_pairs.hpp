// Products of lanes that keep what rounding cuts off.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/numbers/two_product.hpp>

namespace hvi {

// NOTE: in the namespace of Lanes, where templates that were defined before find them.

/// Returns x such that the compiler no longer knows that it was a product; see opaque() of numbers.
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] Lanes<Number, count, most> opaque(const Lanes<Number, count, most>& x) {
    typename Lanes<Number, count, most>::Row row;
    x.store(row);
    for (Number& each : row.at) { each = detail::opaque(each); }
    return row;
}

namespace detail {

/// Whether each product is rounded, as the processor is known to have no instruction that
/// multiplies and adds.
#if defined(__x86_64__) && !defined(__FMA__)
inline constexpr bool products_are_rounded = true;
#else
inline constexpr bool products_are_rounded = false;
#endif

/// Returns what rounding cuts off from a * b, by halves as two_product() of numbers does. `Part`
/// holds one Number, or several.
template <class Number, class Part>
[[nodiscard]] Part cut_off_from_product(const Part& a, const Part& b) {
    const Part factor(Number(1 / power_of_two<Number>(-(bits<Number> + 1) / 2) + 1));
    const Part scaled_a = factor * a, scaled_b = factor * b;
    const Part a_hi = scaled_a - (scaled_a - a), b_hi = scaled_b - (scaled_b - b);
    const Part a_lo = a - a_hi, b_lo = b - b_hi;
    return ((a_hi * b_hi - a * b) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo;
}

}  // namespace detail

/// Returns hi + lo == x * y in each lane. NOTE: by halves in registers; number by number where one
/// instruction does it, of which compilers make those of registers.
template <class Number, std::size_t count, std::size_t most>
[[nodiscard]] detail::Pair<Lanes<Number, count, most>>
two_product(const Lanes<Number, count, most>& x, const Lanes<Number, count, most>& y) {
    if constexpr (detail::products_are_rounded && !std::is_same_v<Number, long double>) {
        return {x * y, x.map(y, [](const auto& a, const auto& b) {
                    return detail::cut_off_from_product<Number>(a, b);
                })};
    }
    typename Lanes<Number, count, most>::Row a, b;
    x.store(a);
    y.store(b);
    for (std::size_t i = 0; i < a.places; ++i) {
        const detail::Pair<Number> product = detail::two_product(a.at[i], b.at[i]);
        a.at[i] = product.hi;
        b.at[i] = product.lo;
    }
    return {a, b};
}

namespace detail {

/// Returns the largest power of two that is not above `count`.
[[nodiscard]] constexpr std::size_t power_of_two_in(std::size_t count) {
    std::size_t power = 1;
    while (2 * power <= count) { power *= 2; }
    return power;
}

/// Returns the sum of `count` numbers; `lo` is what rounding cuts off from `hi`. Half of the
/// numbers are added to the other half at once.
template <std::size_t count, class Number>
[[nodiscard, gnu::always_inline]] inline Pair<Number> exact_sum_of(const Number* from) {
    constexpr std::size_t power = power_of_two_in(count);
    if constexpr (count == 1) {
        return {*from, Number(0)};
    } else if constexpr (count == power && count > 2) {
        using Half = Lanes<Number, count / 2>;
        const Sum<Half> both = two_sum(Half::load(from), Half::load(from + count / 2));
        Number values[count / 2];
        both.value.store(values);
        const Pair<Number> rest = exact_sum_of<count / 2>(&values[0]);
        return {rest.hi, rest.lo + sum(both.remainder)};
    } else {
        constexpr std::size_t left_count = count == power ? 1 : power;
        const Pair<Number> left = exact_sum_of<left_count>(from);
        const Pair<Number> right = exact_sum_of<count - left_count>(from + left_count);
        const Sum<Number> both = two_sum(left.hi, right.hi);
        return {both.value, both.remainder + (left.lo + right.lo)};
    }
}

}  // namespace detail
}  // namespace hvi
