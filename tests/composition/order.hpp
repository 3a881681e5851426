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

/// By how much halving the steps brings the end nearer to its limit, twice, as a power of two.
/// `end(n)` is the state after n steps, in long double.
template <class End>
double order(End end, int steps) {
    const auto a = end(steps), b = end(2 * steps), c = end(4 * steps);
    INFO(static_cast<double>(distance(b, c)));
    REQUIRE(distance(b, c) > 1e-16L);  // far above the rounding of long double
    return static_cast<double>(std::log2(distance(a, b) / distance(b, c)));
}

}  // namespace hvi::tests
