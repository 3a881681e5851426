// Common parts of the tests of rotations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include <catch2/catch.hpp>
#include <hvi/detail/groups/space.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/state.hpp>

namespace groups {

using Code = hvi::Status::Code;
using hvi::detail::Matrix3;
using hvi::detail::Vector3;

/// Where so many steps lead by a time.
template <class Stepper>
typename Stepper::State end(double time, int count) {
    Stepper stepper;
    auto x = Stepper::initial();
    for (int i = 0; i < count; ++i) { REQUIRE(stepper.step(x, time / count).ok()); }
    return x;
}

/// Returns the distance of all numbers of two states, of any steppers.
template <class Stepper, class Other>
double distance(const typename Stepper::State& x, const typename Other::State& y) {
    const auto a = hvi::detail::numbers<Stepper>(x);
    const auto b = hvi::detail::numbers<Other>(y);
    REQUIRE(a.size() == b.size());
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        largest = std::fmax(largest, std::abs(a[k] - b[k]));
    }
    return largest;
}

template <class Stepper>
bool same_bits(const typename Stepper::State& x, const typename Stepper::State& y) {
    const auto a = hvi::detail::numbers<Stepper>(x);
    const auto b = hvi::detail::numbers<Stepper>(y);
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// The largest entry of R^T R - 1.
inline double defect(const std::array<double, 9>& R) {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            double entry = i == j ? -1 : 0;
            for (std::size_t k = 0; k < 3; ++k) { entry += R[3 * k + i] * R[3 * k + j]; }
            largest = std::fmax(largest, std::abs(entry));
        }
    }
    return largest;
}

}  // namespace groups
