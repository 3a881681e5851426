// The flow of two bodies in dual numbers.
// SPDX-License-Identifier: MIT
//
// NOTE: to be included before the header of a stepper, as dual.hpp is.
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/dual.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/stages/two_bodies.hpp>

namespace hvi::detail {

/// Returns G_k = s^k/k! - beta s^(k+2)/(k+2)! + ... for k = 4, 5, from G_(k-2), here `lower`.
template <class Number>
[[nodiscard]] Number higher_universal(std::size_t k, const Number& beta, const Number& s,
                                      const Number& lower) {
    Number power = 1;  // s^(k-2)/(k-2)!
    for (std::size_t i = 1; i <= k - 2; ++i) { power *= s / static_cast<Number>(i); }
    const Number x = beta * s * s;
    if (abs(x) > 1) { return (power - lower) / beta; }
    Number term = power * s * s / static_cast<Number>((k - 1) * k), sum = 0;
    for (std::size_t i = k; sum + term != sum; i += 2) {
        sum += term;
        term *= -x / static_cast<Number>((i + 1) * (i + 2));
    }
    return sum;
}

/// Changes along one orbit: f - 1, g - time, f' and g' - 1.
template <class Number>
using OrbitChange = std::array<Number, 4>;

/// Returns the changes with their derivatives; `values` are the changes, and mu is not 0. With F =
/// r_0 G_1 + eta G_2 + mu G_3 - time = 0 it is ds = -dF/r, and dG_k/dbeta = (k G_(k+2) - s
/// G_(k+1))/2 (Stumpff).
template <class Number, std::size_t n>
[[nodiscard]] OrbitChange<Dual<Number, n>>
change_in_duals(const Dual<Number, n>& r2, const Dual<Number, n>& eta, const Dual<Number, n>& v2,
                const Dual<Number, n>& mu, const Dual<Number, n>& time,
                const OrbitChange<Number>& values) {
    using Dual = detail::Dual<Number, n>;
    const Dual r_0 = math::sqrt(r2), beta = mu / r_0 + mu / r_0 - v2;
    const Number f = 1 + values[0], g = time.value + values[1];
    const Number r = math::sqrt(f * f * r2.value + 2 * f * g * eta.value + g * g * v2.value);
    const Number G_1 = -values[2] * r * r_0.value / mu.value;
    const Number G_2 = -values[0] * r_0.value / mu.value, G_3 = -values[1] / mu.value;
    const Number s = G_1 + beta.value * G_3;
    const Number G_4 = higher_universal(4, beta.value, s, G_2);
    const Number G_5 = higher_universal(5, beta.value, s, G_3);
    const auto at_fixed_s = [&](const Number& value, const Number& slope) {
        return chain(beta, value, slope);
    };
    const Dual fixed_1 = at_fixed_s(G_1, (G_3 - s * G_2) / 2);
    const Dual fixed_2 = at_fixed_s(G_2, (2 * G_4 - s * G_3) / 2);
    const Dual fixed_3 = at_fixed_s(G_3, (3 * G_5 - s * G_4) / 2);
    const Dual F = r_0 * fixed_1 + eta * fixed_2 + mu * fixed_3 - time;
    const auto moved = [&](const Dual& fixed, const Number& slope) {
        Dual result = fixed;
        for (std::size_t i = 0; i < n; ++i) { result.by[i] -= slope * F.by[i] / r; }
        return result;
    };
    const Dual universal_1 = moved(fixed_1, 1 - beta.value * G_2);
    const Dual universal_2 = moved(fixed_2, G_1), universal_3 = moved(fixed_3, G_2);
    const Dual distance = r_0 * (1 - beta * universal_2) + eta * universal_1 + mu * universal_2;
    OrbitChange<Dual> changes{-(mu * universal_2) / r_0, -(mu * universal_3),
                              -(mu * universal_1) / (distance * r_0),
                              -(mu * universal_2) / distance};
    for (std::size_t kind = 0; kind < changes.size(); ++kind) {
        changes[kind].value = values[kind];
    }
    return changes;
}

/// Changes of orbits in dual numbers.
template <class Real, std::size_t parts>
struct OrbitValues<Dual<Real, parts>> {
    using Number = Dual<Real, parts>;

    template <std::size_t n>
    [[nodiscard]] static std::array<Number, 4 * n> of(const std::array<Number, 4 * n + 1>& given) {
        std::array<Real, 4 * n + 1> numbers{};
        for (std::size_t k = 0; k < given.size(); ++k) { numbers[k] = given[k].value; }
        const std::array<Real, 4 * n> values = orbit_values<n>(numbers);
        std::array<Number, 4 * n> result{};
        for (std::size_t j = 0; j < n; ++j) {
            if (numbers[3 * n + j] == 0) { continue; }
            const auto changes = change_in_duals<Real, parts>(
                given[j], given[n + j], given[2 * n + j], given[3 * n + j], given[4 * n],
                {values[j], values[n + j], values[2 * n + j], values[3 * n + j]});
            for (std::size_t kind = 0; kind < 4; ++kind) { result[kind * n + j] = changes[kind]; }
        }
        return result;
    }
};

}  // namespace hvi::detail
