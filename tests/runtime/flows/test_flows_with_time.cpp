// Flows of an H that depends on the time, beside closed forms and steps of another kind.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>
#include <hvi/detail/trajectories/flat.hpp>

#include "flows/damped.hpp"
#include "flows/damped_kahan_li.hpp"
#include "flows/driven.hpp"
#include "flows/driven_kahan_li.hpp"
#include "flows/falling.hpp"
#include "flows/kicked_bond.hpp"
#include "flows/kicked_bond_gauss.hpp"
#include "flows/shaken_top.hpp"
#include "flows/shaken_top_gauss.hpp"
#include "tests/runtime/flows/largest_difference.hpp"

namespace {

namespace made = hvi::generated;
using hvi::test::largest_difference;

/// A position and a momentum.
using Point = std::array<double, 2>;

/// Returns where the driven oscillator of the scene is: its forced motion and a free one.
Point driven_at(double t) {
    const double k = 2, f = 0.75, w = 3, root = std::sqrt(k);
    const double size = f / (k - w * w), a = 1 - size, b = -0.5 / root;
    return {size * std::cos(w * t) + a * std::cos(root * t) + b * std::sin(root * t),
            -size * w * std::sin(w * t) + root * (b * std::cos(root * t) - a * std::sin(root * t))};
}

/// Returns where the oscillator with friction is: q'' + c q' + k q = 0, and p = exp(c t) q'.
Point damped_at(double t) {
    const double c = 0.25, k = 2, root = std::sqrt(k - c * c / 4), b = c / (2 * root);
    const double fade = std::exp(-c * t / 2);
    const double q = fade * (std::cos(root * t) + b * std::sin(root * t));
    const double velocity = -fade * (root + c * b / 2) * std::sin(root * t);
    return {q, std::exp(c * t) * velocity};
}

/// Returns the state after so many steps from the scene's start.
template <class Stepper>
auto after_steps(double h, int steps) {
    Stepper stepper;
    auto x = Stepper::initial();
    for (int k = 0; k < steps; ++k) { REQUIRE(stepper.step(x, h).ok()); }
    return x;
}

template <class State>
double distance(const State& x, const Point& expected) {
    return std::max(std::abs(x.q[0] - expected[0]), std::abs(x.p[0] - expected[1]));
}

}  // namespace

TEST_CASE("a kick is that of the time at which it comes") {
    // NOTE: half a drift, p + h (t + h/2), half a drift: p = t^2/2, and q is a sum of squares.
    const double h = 0.125;
    for (const int n : {1, 2, 10}) {
        const auto x = after_steps<made::Falling>(h, n);
        const double t = n * h;
        const double sum = (n - 1.0) * n * (2.0 * n - 1) / 12 + n * (n - 1.0) / 4 + n / 4.0;
        CHECK(x.t == t);
        CHECK(x.p[0] == Approx(t * t / 2).epsilon(1e-15));
        CHECK(x.q[0] == Approx(h * h * h * sum).epsilon(1e-15));
    }
}

TEST_CASE("a splitting of an H with the time has its order") {
    const auto errors = [](auto at, auto stepper) {
        const auto error = [&](int steps) {
            return distance(after_steps<decltype(stepper)>(4.0 / steps, steps), at(4));
        };
        return std::array<double, 2>{error(64), error(128)};
    };
    const auto of_driven = errors(driven_at, made::Driven());
    CHECK(of_driven[0] / of_driven[1] == Approx(4).margin(0.1));
    const auto of_damped = errors(damped_at, made::Damped());
    CHECK(of_damped[0] / of_damped[1] == Approx(4).margin(0.1));
    CHECK(distance(after_steps<made::DrivenKahanLi>(1.0 / 32, 128), driven_at(4)) < 1e-13);
    CHECK(distance(after_steps<made::DampedKahanLi>(1.0 / 32, 128), damped_at(4)) < 1e-13);
}

TEST_CASE("steps with the time go back the way they came") {
    made::DrivenKahanLi stepper;
    const auto start = made::DrivenKahanLi::initial();
    auto x = start;
    for (int k = 0; k < 1000; ++k) { REQUIRE(stepper.step(x, 0.125).ok()); }
    for (int k = 0; k < 1000; ++k) { REQUIRE(stepper.step(x, -0.125).ok()); }
    CHECK(std::abs(x.t) < 1e-15);
    CHECK(largest_difference(x, start) < 1e-13);
}

TEST_CASE("the time of a long run is summed with compensation, in single steps and in a row") {
    // NOTE: a million tenths are 100000 and 5.6e-12, which is less than half of a unit there.
    made::Driven single, row;
    auto x = made::Driven::initial(), y = x;
    for (int k = 0; k < 1000000; ++k) { REQUIRE(single.step(x, 0.1).ok()); }
    CHECK(x.t == 100000);
    const hvi::Run run = row.advance(y, 0.1, 1000000);
    REQUIRE(run.ok());
    CHECK(y.t == 100000);
    CHECK(largest_difference(x, y) < 1e-9);
}

TEST_CASE("bodies that turn feel the time, in single steps and in a row") {
    const double h = 1.0 / 32;
    const int steps = 320;
    const auto expected = after_steps<made::ShakenTopGauss>(h, steps);
    const auto x = after_steps<made::ShakenTop>(h, steps);
    const auto numbers = [](const auto& bodies) {
        return hvi::detail::flat<made::ShakenTop>(bodies);
    };
    const auto there = hvi::detail::flat<made::ShakenTopGauss>(expected);
    double largest = 0;
    for (std::size_t k = 0; k < 9; ++k) {
        largest = std::max(largest, std::abs(numbers(x).q[k] - there.q[k]));
    }
    CHECK(largest < 1e-11);
    CHECK(x.t == 10);
    made::ShakenTop row;
    auto y = made::ShakenTop::initial();
    REQUIRE(row.advance(y, h, steps).ok());
    CHECK(y.t == 10);
    CHECK(largest_difference(numbers(x), numbers(y)) < 1e-13);
}

TEST_CASE("small steps with the time have order two") {
    const auto expected = after_steps<made::KickedBondGauss>(1.0 / 128, 512);
    const auto error = [&](int steps) {
        const auto x = after_steps<made::KickedBond>(4.0 / steps, steps);
        return std::max({std::abs(x.q[0] - expected.q[0]), std::abs(x.q[1] - expected.q[1]),
                         std::abs(x.p[0] - expected.p[0]), std::abs(x.p[1] - expected.p[1])});
    };
    CHECK(error(512) < 1e-3);
    CHECK(error(512) / error(1024) == Approx(4).margin(0.1));
}

TEST_CASE("a step to no finite time leaves the state and the time") {
    made::Driven stepper;
    auto x = made::Driven::initial();
    REQUIRE(stepper.step(x, 0.5).ok());
    const auto before = x;
    CHECK(stepper.step(x, std::numeric_limits<double>::infinity()).code() ==
          hvi::Status::Code::not_finite);
    CHECK(stepper.advance(x, std::numeric_limits<double>::max(), 3).steps == 0);
    CHECK((x.t == before.t && x.q == before.q && x.p == before.p));
}
