// Steps of one trajectory on a device: weights, sums, and the end of a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/device/sums.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

template <class Number>
inline constexpr device::Real<Number> epsilon<device::Real<Number>> = epsilon<Number>;

}  // namespace hvi::detail

namespace hvi::device {

// ---- on the host: what all trajectories share ----

/// Sets `weights` to h b_i as set_weights_of_step() does.
template <class Number, std::size_t n>
void weigh(Number h, const Number (&b)[n], Vector<Number, n>& weights) {
    Real<Number> exact[n], weighed[n];
    for (std::size_t i = 0; i < n; ++i) { exact[i] = b[i]; }
    detail::set_weights_of_step<Real<Number>>(h, exact, n, weighed);
    for (std::size_t i = 0; i < n; ++i) { weights[i] = weighed[i].value; }
}

/// Sets `sizes` to h b_i, each rounded for itself.
template <class Number, std::size_t n>
void scale(Number h, const Number (&b)[n], Vector<Number, n>& sizes) {
    for (std::size_t i = 0; i < n; ++i) { sizes[i] = product(h, b[i]); }
}

// ---- on the device ----

/// Sets `sum` to from + change, and `change` to the remainder of the sum.
template <class Number, std::size_t n>
HVI_DEVICE constexpr void add(const Vector<Number, n>& from, Vector<Real<Number>, n>& change,
                              Vector<Real<Number>, n>& sum) {
    for (std::size_t k = 0; k < n; ++k) {
        const Sum<Number> exact = two_sum<Number>(from[k], change[k]);
        sum[k] = exact.value;
        change[k] = exact.remainder;
    }
}

template <class Number, std::size_t n>
[[nodiscard]] HVI_DEVICE constexpr bool are_finite(const Vector<Real<Number>, n>& q,
                                                   const Vector<Real<Number>, n>& p) {
    Real<Number> zero = 0;
    for (std::size_t k = 0; k < n; ++k) { zero += (q[k] - q[k]) + (p[k] - p[k]); }
    return zero == Real<Number>(0);
}

/// Returns T_i = t + c_i h, where `path` is c_i h.
template <class State, class Number>
[[nodiscard]] HVI_DEVICE constexpr Real<Number> time_at(const State& x, Number path) {
    return Real<Number>(x.t) + (Real<Number>(x.remainder_t) + path);
}

/// Returns the time at the end of a step.
template <class State, class Number>
[[nodiscard]] HVI_DEVICE constexpr Sum<Number> time_after(const State& x, Number h) {
    return two_sum<Number>(x.t, Real<Number>(x.remainder_t) + h);
}

}  // namespace hvi::device
