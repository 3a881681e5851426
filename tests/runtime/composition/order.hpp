// The order of steps, measured by halving them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>

namespace hvi::tests {

/// Euclidean.
template <class State>
long double distance(const State& x, const State& y) {
    long double sum = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        sum += (x.q[k] - y.q[k]) * (x.q[k] - y.q[k]) + (x.p[k] - y.p[k]) * (x.p[k] - y.p[k]);
    }
    return std::sqrt(sum);
}

/// Where steps from x end, which all succeed.
template <class Stepper>
typename Stepper::State end_of(typename Stepper::State x, long double until, int steps) {
    Stepper stepper;
    for (int i = 0; i < steps; ++i) { REQUIRE(stepper.step(x, until / steps).ok()); }
    return x;
}

/// Returns the observed order: the power of two by which halving the steps, twice, brings the end
/// nearer to its limit. Scalars are long double.
template <class Stepper>
double order(const typename Stepper::State& start, long double until, int steps) {
    const auto a = end_of<Stepper>(start, until, steps),
               b = end_of<Stepper>(start, until, 2 * steps),
               c = end_of<Stepper>(start, until, 4 * steps);
    INFO(static_cast<double>(distance(b, c)));
    REQUIRE(distance(b, c) > 1e-16L);  // far above the rounding of long double
    return static_cast<double>(std::log2(distance(a, b) / distance(b, c)));
}

}  // namespace hvi::tests
