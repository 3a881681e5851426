// The functions of several angles side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/groups/entire_functions.hpp>
#include <hvi/detail/lanes/lanes.hpp>

namespace hvi {

namespace detail {

template <class Number, std::size_t count, std::size_t most>
struct NumberWithin<Lanes<Number, count, most>> {
    using type = Number;
};

/// Returns the functions angle by angle. NOTE: not inlined, as this rare case would take registers
/// from the common one.
template <class Number, std::size_t count, std::size_t most>
[[nodiscard, gnu::noinline, gnu::cold]] AngleFunctions<Lanes<Number, count, most>>
angle_functions_one_by_one(const Lanes<Number, count, most>& y) {
    typename Lanes<Number, count, most>::Row from;
    std::array<typename Lanes<Number, count, most>::Row, 7> c{};
    y.store(from);
    for (std::size_t i = 0; i < count; ++i) {
        const AngleFunctions<Number> of = angle_functions(from[i]);
        const std::array<Number, 7> all{of.c1, of.c2, of.c3, of.c4, of.c5, of.c6, of.c7};
        for (std::size_t k = 0; k < all.size(); ++k) { c[k].set(i, all[k]); }
    }
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6]};
}

}  // namespace detail

// NOTE: in the namespace of Lanes, where templates that were defined before find it.

/// Returns the functions of the angles whose squares are y: by series unless one of them is large.
template <class Number, std::size_t count, std::size_t most>
[[nodiscard, gnu::always_inline]] inline detail::AngleFunctions<Lanes<Number, count, most>>
angle_functions(const Lanes<Number, count, most>& y) {
    using Lane = Lanes<Number, count, most>;
    if (any(Lane(Number(detail::angles::switch_at)) < y)) {
        return detail::angle_functions_one_by_one(y);
    }
    return detail::angles::by_series(y);
}

}  // namespace hvi
