// A state as its numbers: q, then p.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace hvi::detail {

template <class Stepper, class = void>
struct HasFlat : std::false_type {};
template <class Stepper>
struct HasFlat<Stepper,
               std::void_t<decltype(Stepper::flat(std::declval<const typename Stepper::State&>()))>>
    : std::true_type {};

/// Returns a state with all of its numbers in q and p, those of rotations included; without
/// rotations the state itself.
template <class Stepper>
[[nodiscard]] decltype(auto) flat(const typename Stepper::State& x) {
    if constexpr (HasFlat<Stepper>::value) {
        return Stepper::flat(x);
    } else {
        return (x);
    }
}

/// Sets x from such a state.
template <class Stepper, class Flat>
void set_flat(typename Stepper::State& x, const Flat& at) {
    if constexpr (HasFlat<Stepper>::value) {
        Stepper::set(x, at);
    } else {
        x = at;
    }
}

/// Writes the numbers one after the other. Returns their end.
template <class Stepper>
double* write_numbers(const typename Stepper::State& x, double* out) {
    const auto& at = flat<Stepper>(x);
    for (const auto& value : at.q) { *out++ = static_cast<double>(value); }
    for (const auto& value : at.p) { *out++ = static_cast<double>(value); }
    return out;
}

/// Sets x to these numbers, as many as it has. Returns their end.
template <class Stepper>
const double* read_numbers(typename Stepper::State& x, const double* all) {
    auto at = flat<Stepper>(x);
    for (auto& value : at.q) { value = *all++; }
    for (auto& value : at.p) { value = *all++; }
    set_flat<Stepper>(x, at);
    return all;
}

/// Returns all numbers in one list.
template <class Stepper>
[[nodiscard]] std::vector<double> numbers(const typename Stepper::State& x) {
    const auto& at = flat<Stepper>(x);
    std::vector<double> all(at.q.size() + at.p.size());
    write_numbers<Stepper>(x, all.data());
    return all;
}

}  // namespace hvi::detail
