// Newton's method where fixed points do not contract.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/generated/lobatto_3_separable.hpp>
#include <hvi/generated/trig3.hpp>
#include <hvi/newton.hpp>

#include "systems.hpp"

using namespace hvi::generated;

namespace {

template <class Stepper>
void keeps_energy(Stepper stepper, double w, double h) {
    hvi::State<systems::One> x{{1.0}, {0.5 * w}};
    const double energy = (x.p[0] * x.p[0] + w * w * x.q[0] * x.q[0]) / 2;
    int iterations = 0;
    for (int i = 0; i < 1000; ++i) {
        const hvi::Status status = stepper.step(x, h);
        REQUIRE(status.ok());
        iterations += status.iterations;
    }
    const double now = (x.p[0] * x.p[0] + w * w * x.q[0] * x.q[0]) / 2;
    CHECK(std::abs(now / energy - 1.0) < 2e-13);
    CHECK(iterations <= 5 * 1000);
}

}  // namespace

TEST_CASE("Gauss with Newton's method keeps the energy of a stiff oscillator") {
    for (const double w : {1.0, 1e4}) {
        const double h = 1e4 / w;
        keeps_energy(Gauss2<systems::Oscillator, hvi::Newton>{systems::Oscillator{w}}, w, h);
        keeps_energy(Gauss4<systems::Oscillator, hvi::Newton>{systems::Oscillator{w}}, w, h);
        keeps_energy(
            Gauss2Separable<systems::SeparableOscillator, hvi::Newton>{
                systems::SeparableOscillator{w}},
            w, h);
    }
}

TEST_CASE("corrections that creep along the last bit end Newton's method") {
    // One step in 3000 or so took all iterations there are, and failed.
    constexpr double w = 1e4, h = 10 / w;
    Gauss2<systems::Oscillator, hvi::Newton> stepper{systems::Oscillator{w}};
    hvi::State<systems::One> x{{1.0}, {0.5 * w}};
    int most = 0;
    for (int i = 0; i < 20000; ++i) {
        const hvi::Status status = stepper.step(x, h);
        REQUIRE(status.ok());
        most = std::max(most, status.iterations);
    }
    CHECK(most <= 15);
}

TEST_CASE("a stiff step with gauss:2 and Newton's method is (6.6)") {
    const double h = 1e4;
    const double z2 = h * h;
    const double D = (z2 + 12) * z2 + 144;
    hvi::State<systems::One> x{{2.0}, {1.0}};
    REQUIRE(Gauss2<systems::Oscillator, hvi::Newton>{}.step(x, h).ok());
    CHECK(systems::ulps(x.q[0], (2 * ((z2 - 60) * z2 + 144) + h * (144 - 12 * z2)) / D) <= 8);
    CHECK(systems::ulps(x.p[0], (2 * h * (12 * z2 - 144) + (z2 - 60) * z2 + 144) / D) <= 8);
}

TEST_CASE("the fixed point says that it does not converge on a stiff step") {
    hvi::State<systems::One> x{{1.0}, {0.5}};
    const auto before = x;
    for (const double h : {5.0, 20.0, 1e4}) {
        CHECK_FALSE(Gauss2<systems::Oscillator>{}.step(x, h).ok());
        CHECK_FALSE(Gauss2Separable<systems::SeparableOscillator>{}.step(x, h).ok());
        CHECK_FALSE(Lobatto3Separable<systems::SeparableOscillator>{}.step(x, h).ok());
    }
    CHECK(systems::same_bits(x, before));
}

TEST_CASE("a step at a pole of the method is a status or far away, never a crash") {
    // The stage equations of trig3 are singular near z = 7.38.
    hvi::State<systems::One> x{{1.0}, {0.5}};
    double lowest = 7.0, highest = 8.0;
    const auto sign = [&](double h) {
        hvi::State<systems::One> y{{1.0}, {0.5}};
        const hvi::Status status = Trig3<systems::Oscillator, hvi::Newton>{}.step(y, h);
        return !status.ok() ? 0 : y.q[0] > 0 ? 1 : -1;
    };
    REQUIRE(sign(lowest) * sign(highest) == -1);
    const int below = sign(lowest);
    for (int i = 0; i < 60 && sign((lowest + highest) / 2) != 0; ++i) {
        const double middle = (lowest + highest) / 2;
        (sign(middle) == below ? lowest : highest) = middle;
    }
    const auto before = x;
    const hvi::Status status =
        Trig3<systems::Oscillator, hvi::Newton>{}.step(x, (lowest + highest) / 2);
    CHECK_FALSE(status.ok());
    CHECK(systems::same_bits(x, before));
}
