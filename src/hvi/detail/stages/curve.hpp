// The curve between the ends of a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// Returns sum_k table[i][k-1] g_k(tau) for each slope i, the distance of the curve from its chord,
/// with g_k(tau) = (P_{k+1} - P_{k-1})(2 tau - 1)/2 of Legendre's polynomials. At tau = 0 and 1 the
/// sum is 0 without rounding, as the recurrence gives P_k = 1 and -1 exactly there.
template <class Scalar, std::size_t slopes, std::size_t functions>
[[nodiscard]] std::array<Scalar, slopes> departures(const Scalar (&table)[slopes][functions],
                                                    Scalar tau) {
    std::array<Scalar, slopes> sums{};
    const Scalar x = 2 * tau - 1;
    Scalar before = 1;
    Scalar P = x;
    for (std::size_t k = 1; k <= functions; ++k) {
        const Scalar next =
            (static_cast<Scalar>(2 * k + 1) * x * P - static_cast<Scalar>(k) * before) /
            static_cast<Scalar>(k + 1);
        const Scalar g = (next - before) / 2;
        for (std::size_t i = 0; i < slopes; ++i) { sums[i] += table[i][k - 1] * g; }
        before = P;
        P = next;
    }
    return sums;
}

/// Returns the sums with g_k(tau) = at_tau_k - tau at_one_k.
template <class Scalar, std::size_t slopes, std::size_t functions>
[[nodiscard]] std::array<Scalar, slopes> departures(const Scalar (&table)[slopes][functions],
                                                    Scalar tau,
                                                    const std::array<Scalar, functions>& at_tau,
                                                    const std::array<Scalar, functions>& at_one) {
    std::array<Scalar, slopes> sums{};
    for (std::size_t k = 0; k < functions; ++k) {
        const Scalar g = at_tau[k] - tau * at_one[k];
        for (std::size_t i = 0; i < slopes; ++i) { sums[i] += table[i][k] * g; }
    }
    return sums;
}

/// Returns v with NaN in all its components.
template <class Vector>
[[nodiscard]] Vector nowhere(Vector v = {}) {
    // NOTE: NaN of float, as the standard library may know none of __float128.
    const auto nan = static_cast<ScalarOf<Vector>>(std::numeric_limits<float>::quiet_NaN());
    for (IndexOf<Vector> k = 0; k < v.size(); ++k) { v[k] = nan; }
    return v;
}

}  // namespace hvi::detail
