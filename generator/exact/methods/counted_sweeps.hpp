// A step of a counted number of sweeps, as an explicit method of its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/exact/methods/order.hpp"
#include "generator/exact/methods/oscillator.hpp"
#include "generator/exact/methods/swept_stages.hpp"

namespace hvi::gen {

/// The largest power of h up to which something is proved to hold.
struct PowerOfStep {
    int power = 0;
    bool is_at_least = false;  ///< it holds as far as was looked
};

/// Steps of K sweeps from the slopes at the start of each, on systems of one family.
struct SweptFamily {
    OrderConditions order;
    PowerOfStep agrees;      ///< trees of so many vertices have the weights of the method
    PowerOfStep symplectic;  ///< the derivative D of a step has D^T J D = J + O(h^(power+1))
};

/// Returns what such a step is. Conditions of symplecticity are those of Hairer, Lubich & Wanner,
/// Geometric Numerical Integration, Section VI.7, for trees u and v with up to `power` vertices
/// together:
///
///     a(u o v) + a(v o u) = a(u) a(v),    u with a root f, v with a root g,
///
/// and for any H that the weights a of a tree do not depend on the colour of its root. Where T is
/// quadratic no f has more than one child, and of two trees with a root g their difference stands:
///
///     a(v o f[u]) - a(u o f[v]) = a(f[u]) a(v) - a(f[v]) a(u).
///
/// Methods that hold them up to a power are called pseudo-symplectic (Aubry & Chartier, BIT 38
/// (1998) 439). Preconditions: 1 <= max_order <= most_vertices, sweeps > 0; the form is
/// SweepForm::positions for the family nystrom alone. Throws MathError where the coefficients are
/// known by enclosures alone, and TooLarge.
[[nodiscard]] SweptFamily swept_family(const Tableau& tableau, SweepForm form, TreeFamily family,
                                       int sweeps, int max_order);

/// Returns the map of such a step, of SweepForm::positions: polynomials, the Taylor series of the
/// method's map as far as the sweeps reach. Throws likewise.
[[nodiscard]] OscillatorMap swept_oscillator(const Tableau& tableau, int sweeps);

/// A coefficient of a polynomial in z.
struct Term {
    Number coefficient;
    std::size_t power;
};

/// Returns the first term of the determinant of a map without a denominator, beside the 1: where
/// its eigenvalues are not real, a step multiplies the energy by the determinant, but for what
/// oscillates. Empty where the determinant is 1.
[[nodiscard]] std::optional<Term> first_of_determinant(const OscillatorMap& map);

/// Returns the largest n, up to a limit, with A c^(k-1) = c^k/k and the same of A~ for k = 1 .. n:
/// a slope at a stage is that of the motion but for O(h^(n+1)). Throws likewise.
[[nodiscard]] int stage_order(const Tableau& tableau);

}  // namespace hvi::gen
