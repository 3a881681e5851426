// The distance of two states of steps that are flows.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hvi::test {

/// Returns the largest difference of the numbers of two states.
template <class State>
double largest_difference(const State& left, const State& right) {
    double largest = 0;
    const auto see = [&](const auto& a, const auto& b) {
        for (std::size_t k = 0; k < a.size(); ++k) {
            largest = std::max(largest, std::abs(a[k] - b[k]));
        }
    };
    see(left.q, right.q);
    see(left.p, right.p);
    return largest;
}

}  // namespace hvi::test
