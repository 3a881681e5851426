// A state as its numbers: q, then p.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace hvi::driver {

template <class Stepper, class = void>
struct HasFlat : std::false_type {};
template <class Stepper>
struct HasFlat<Stepper,
               std::void_t<decltype(Stepper::flat(std::declval<const typename Stepper::State&>()))>>
    : std::true_type {};

/// The state with all of its numbers in q and p, of a stepper with rotations those too, or itself.
template <class Stepper>
[[nodiscard]] decltype(auto) flat(const typename Stepper::State& x) {
    if constexpr (HasFlat<Stepper>::value) {
        return Stepper::flat(x);
    } else {
        return (x);
    }
}

/// All of them in one list.
template <class Stepper>
[[nodiscard]] std::vector<double> numbers(const typename Stepper::State& x) {
    const auto& at = flat<Stepper>(x);
    std::vector<double> all(at.q.begin(), at.q.end());
    all.insert(all.end(), at.p.begin(), at.p.end());
    return all;
}

/// Sets x to these. Precondition: there are as many as numbers(x) are.
template <class Stepper>
void set_numbers(typename Stepper::State& x, const std::vector<double>& all) {
    const auto copy = [&](auto& at) {
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(at.q.size());
        std::copy(all.begin(), middle, at.q.begin());
        std::copy(middle, all.end(), at.p.begin());
    };
    if constexpr (HasFlat<Stepper>::value) {
        auto at = Stepper::flat(x);
        copy(at);
        Stepper::set(x, at);
    } else {
        copy(x);
    }
}

}  // namespace hvi::driver
