// Canonical coordinates of a state of dual numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include <driver/dual.hpp>
#include <driver/turns.hpp>
#include <hvi/detail/trajectories/flat.hpp>

namespace hvi::driver {

/// Derivatives of a state by canonical coordinates of the start of the run, in canonical
/// coordinates of the state. Canonical coordinates are q and p, and, for a rotation R with the
/// angular momentum L in the body, xi and pi of the natural chart at R. There R exp(hat xi) is the
/// rotation and T(xi)^-T pi the angular momentum, so that at xi = 0
///
///     dR = R hat(dxi),        dpi = dL + dxi x L/2,
///
/// as T(xi)^T = 1 + hat xi/2 + ...
template <class Stepper>
struct CanonicalParts {
    using State = typename Stepper::State;
    static constexpr std::size_t n = std::tuple_size_v<typename Stepper::Vector>;

    /// Derivatives [k][i]: of coordinate k by coordinate i of the start, the q before the p.
    using Parts = std::array<std::array<double, 2 * n>, n>;

    /// Makes the state the start, by which all are differentiated.
    static void begin(State& x) {
        if constexpr (detail::HasFlat<Stepper>::value) {
            auto at = Stepper::flat(x);
            for (std::size_t k = 0; k < flat_ones(); ++k) { make_variable(at, k); }
            for (std::size_t r = 0; r < rotations(); ++r) { begin_rotation(at, r); }
            Stepper::set(x, at);
        } else {
            for (std::size_t k = 0; k < n; ++k) { make_variable(x, k); }
        }
    }

    /// Returns the derivatives of q and of p.
    [[nodiscard]] static std::pair<Parts, Parts> of(const State& x) {
        std::pair<Parts, Parts> parts{};
        const auto& at = detail::flat<Stepper>(x);
        for (std::size_t i = 0; i < 2 * n; ++i) {
            for (std::size_t k = 0; k < flat_ones(); ++k) {
                parts.first[k][i] = at.q[k].by[i];
                parts.second[k][i] = at.p[k].by[i];
            }
            for (std::size_t r = 0; r < rotations(); ++r) { add_rotation(parts, at, r, i); }
        }
        return parts;
    }

    /// Returns the range of coordinates that share their rounding with coordinate i. Rotations mix
    /// the three axes of a body, and those of all bodies where equations are solved.
    [[nodiscard]] static std::pair<std::size_t, std::size_t> mixed_with(std::size_t i) {
        if (i % n < flat_ones()) { return {i, i + 1}; }
        const std::size_t end = i < n ? n : 2 * n;
        return {end - 3 * rotations(), end};
    }

private:
    static constexpr std::size_t rotations() {
        if constexpr (detail::HasFlat<Stepper>::value) {
            return Stepper::Space::rotations;
        } else {
            return 0;
        }
    }
    static constexpr std::size_t flat_ones() { return n - 3 * rotations(); }
    static constexpr std::size_t first(std::size_t r) { return flat_ones() + 3 * r; }

    template <class At>
    static void make_variable(At& at, std::size_t k) {
        at.q[k] = variable<2 * n>(at.q[k].value, k);
        at.p[k] = variable<2 * n>(at.p[k].value, n + k);
    }

    /// Sets dR = R hat e_a and dL = -e_a x L/2 by xi_a, and dL = e_a by pi_a.
    template <class At>
    static void begin_rotation(At& at, std::size_t r) {
        const std::size_t R = flat_ones() + 9 * r, L = first(r);
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            std::array<double, 3> unit{};
            unit[a] = 1;
            set_turn(&at.q[R], L + a, unit);
            at.p[L + b].by[L + a] = at.p[L + c].value / 2;
            at.p[L + c].by[L + a] = -at.p[L + b].value / 2;
            at.p[L + a].by[n + L + a] = 1;
        }
    }

    template <class At>
    static void add_rotation(std::pair<Parts, Parts>& parts, const At& at, std::size_t r,
                             std::size_t i) {
        const std::size_t R = flat_ones() + 9 * r, L = first(r);
        const std::array<double, 3> dxi = turn_of(&at.q[R], i);
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            parts.first[L + a][i] = dxi[a];
            parts.second[L + a][i] =
                at.p[L + a].by[i] + (dxi[b] * at.p[L + c].value - dxi[c] * at.p[L + b].value) / 2;
        }
    }
};

}  // namespace hvi::driver
