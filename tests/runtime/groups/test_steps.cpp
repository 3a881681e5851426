// Promises of steps of rotations at their edges: statuses, memory, solvers, numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include <groups/driven_2.hpp>
#include <groups/driven_n.hpp>
#include <groups/free_2.hpp>
#include <groups/free_4.hpp>
#include <groups/rotors_2.hpp>
#include <groups/rotors_n.hpp>
#include <groups/spacecraft_2.hpp>
#include <groups/spacecraft_n.hpp>
#include <groups/top_2.hpp>
#include <groups/top_3.hpp>
#include <groups/top_fixed.hpp>
#include <groups/top_newton.hpp>

#include "tests/runtime/groups/groups.hpp"

using namespace hvi::generated;
using groups::Code;

namespace {

template <class Stepper>
Code refused(const typename Stepper::State& x, double h) {
    Stepper stepper;
    auto y = x;
    const hvi::Status status = stepper.step(y, h);
    CHECK(groups::same_bits<Stepper>(x, y));
    return status.code();
}

}  // namespace

TEST_CASE("what is no rotation, or no number, is refused, and the state keeps its bits") {
    const auto start = TopGauss2::initial();
    for (std::size_t k = 0; k < 9; ++k) {
        auto x = start;
        x.R[k] = std::numeric_limits<double>::quiet_NaN();
        CHECK(refused<TopGauss2>(x, 0.1) == Code::not_finite);
        x.R[k] = start.R[k] + 1e-3;
        CHECK(refused<TopGauss2>(x, 0.1) == Code::not_a_rotation);
    }
    auto mirrored = start;
    for (double& entry : mirrored.R) { entry = -entry; }
    CHECK(refused<TopGauss2>(mirrored, 0.1) == Code::not_a_rotation);
    auto x = start;
    x.L[1] = std::numeric_limits<double>::infinity();
    CHECK(refused<TopGauss2>(x, 0.1) == Code::not_finite);
    CHECK(refused<TopGauss2>(start, std::numeric_limits<double>::quiet_NaN()) == Code::not_finite);
    CHECK(refused<TopGauss2>(start, std::numeric_limits<double>::infinity()) == Code::not_finite);
    CHECK(refused<TopGauss2>(start, 0) == Code::ok);
}

TEST_CASE("a step that turns a body by a whole turn is outside of the chart") {
    auto x = FreeGauss2::initial();
    x.L = {0, 0, 3};  // about a principal axis: it turns by 1 in a unit of time
    CHECK(refused<FreeGauss2>(x, 6.4) == Code::outside_chart);
    CHECK(refused<FreeGauss2>(x, 1e6) == Code::outside_chart);
    for (const double angle : {3.1415, 3.1416, 6.0, 6.25}) {
        FreeGauss2 stepper;
        auto y = x;
        CAPTURE(angle);
        REQUIRE(stepper.step(y, angle).ok());
        CHECK(std::abs(y.R[0] - std::cos(angle)) < 1e-13);
        CHECK(std::abs(y.R[3] - std::sin(angle)) < 1e-13);
        CHECK(y.L == x.L);
    }
}

TEST_CASE("spins of any size, and bodies like needles") {
    for (const double spin : {1e-8, 1.0, 1e8}) {
        FreeGauss4 stepper;
        auto x = FreeGauss4::initial();
        for (double& part : x.L) { part *= spin; }
        const double J = stepper.J_2(x), energy = stepper.energy(x);
        for (int i = 0; i < 1000; ++i) { REQUIRE(stepper.step(x, 0.25 / spin).ok()); }
        CHECK(std::abs(stepper.J_2(x) - J) < 1e-15 * spin);
        CHECK(std::abs(stepper.energy(x) / energy - 1) < 1e-12);
        CHECK(groups::defect(x.R) < 5e-15);
    }
    FreeGauss4::Parameters needle;
    needle.inertia = {1e-6, 1, 1};
    FreeGauss4 stepper(needle);
    auto x = FreeGauss4::initial();
    x.L = {1e-6, 1, 0.5};
    const double energy = stepper.energy(x);
    // NOTE: its spin about the axis is stiff: from L at rounding h 1e6 of it turns the body.
    for (int i = 0; i < 1000; ++i) { REQUIRE(stepper.step(x, 0.01).ok()); }
    CHECK(std::abs(stepper.energy(x) / energy - 1) < 1e-12);
    CHECK(std::abs(x.L[0] / 1e-6 - 1) < 1e-9);  // the spin of a symmetric body stays
}

TEST_CASE("fixed points and Newton's method solve the same equations") {
    const auto compare = [](auto&& first, auto&& second, double h) {
        using First = std::decay_t<decltype(first)>;
        using Second = std::decay_t<decltype(second)>;
        auto x = First::initial();
        auto y = Second::initial();
        for (int i = 0; i < 20; ++i) {
            REQUIRE(first.step(x, h).ok());
            REQUIRE(second.step(y, h).ok());
            CHECK(groups::distance<First, Second>(x, y) < 1e-13 * (i + 1));
        }
    };
    compare(TopFixed(), TopNewton(), 0.2);
    compare(Spacecraft2(), SpacecraftN(), 0.1);
    compare(Rotors2(), RotorsN(), 0.1);
    compare(DrivenGauss2(), DrivenNewton(), 0.1);
}

TEST_CASE("Newton's method takes steps on which fixed points do not converge") {
    // Near the lowest point gravity is a stiff spring of frequency 100 and more.
    TopFixed::Parameters stiff;
    stiff.centre = {0, 0, 1};
    stiff.g = 1e5;
    auto x = TopFixed::initial();
    x.R = {1, 0, 0, 0, -1, 0, 0, 0, -1};
    x.L = {1e-3, -2e-3, 1e-3};
    auto y = x;
    TopFixed fixed(stiff);
    CHECK_FALSE(fixed.step(y, 0.1).ok());
    CHECK(groups::same_bits<TopFixed>(x, y));
    TopNewton::Parameters same;
    same.centre = stiff.centre;
    same.g = stiff.g;
    TopNewton newton(same);
    auto z = TopNewton::initial();
    z.R = x.R;
    z.L = x.L;
    const double energy = newton.energy(z), J = newton.J_z(z);
    for (int i = 0; i < 1000; ++i) {
        const hvi::Status status = newton.step(z, 0.1);
        REQUIRE(status.ok());
        CHECK(status.iterations <= 12);
    }
    CHECK(std::abs(newton.energy(z) - energy) < 1e-9 * std::abs(energy));
    CHECK(std::abs(newton.J_z(z) - J) < 1e-15);
}

TEST_CASE("a state that was changed takes the steps of a new stepper, and a copy goes on") {
    TopGauss2 stepper;
    auto x = TopGauss2::initial();
    for (int i = 0; i < 7; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    TopGauss2 copy = stepper;
    auto y = x;
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(copy.step(y, 0.1).ok());
    CHECK(groups::same_bits<TopGauss2>(x, y));

    x.L[0] += 1;
    auto z = x;
    TopGauss2 fresh;
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(fresh.step(z, 0.1).ok());
    CHECK(groups::same_bits<TopGauss2>(x, z));

    stepper.reset();
    fresh.reset();
    auto w = x;
    REQUIRE(stepper.step(x, 0.1).ok());
    TopGauss2 another;
    REQUIRE(another.step(w, 0.1).ok());
    CHECK(groups::same_bits<TopGauss2>(x, w));
}

TEST_CASE("the curve of a step begins and ends with it, and is near the motion between") {
    TopGauss3 stepper;
    auto x = TopGauss3::initial();
    CHECK(std::isnan(stepper.position(0.5).R[0]));
    for (int i = 0; i < 3; ++i) {
        const auto before = x;
        REQUIRE(stepper.step(x, 0.1).ok());
        const auto middle = stepper.position(0.5);
        TopGauss3 half;
        auto y = before;
        for (int k = 0; k < 8; ++k) { REQUIRE(half.step(y, 0.1 / 16).ok()); }
        for (std::size_t k = 0; k < 9; ++k) {
            CHECK(std::abs(stepper.position(0).R[k] - before.R[k]) < 3e-16);
            CHECK(std::abs(stepper.position(1).R[k] - x.R[k]) < 1e-15);
            CHECK(std::abs(middle.R[k] - y.R[k]) < 2e-6);
        }
        CHECK(groups::defect(middle.R) < 3e-15);
    }
    DrivenGauss2 driven;
    auto z = DrivenGauss2::initial();
    REQUIRE(driven.step(z, 0.1).ok());
    CHECK(std::abs(driven.position(1).q[0] - z.q[0]) < 1e-15);
    CHECK(z.t == 0.1);
}

TEST_CASE("long double and float take the same steps, as far as they reach") {
    using Long = BasicTopGauss2<long double>;
    using Short = BasicTopGauss2<float>;
    Long wide;
    Short narrow;
    TopGauss2 stepper;
    auto w = Long::initial();
    auto n = Short::initial();
    auto x = TopGauss2::initial();
    for (int i = 0; i < 50; ++i) {
        REQUIRE(wide.step(w, 0.1L).ok());
        REQUIRE(narrow.step(n, 0.1f).ok());
        REQUIRE(stepper.step(x, 0.1).ok());
    }
    for (std::size_t k = 0; k < 9; ++k) {
        CHECK(std::abs(static_cast<double>(w.R[k]) - x.R[k]) < 1e-13);
        CHECK(std::abs(static_cast<double>(n.R[k]) - x.R[k]) < 1e-4);
    }
    CHECK(std::abs(static_cast<double>(wide.J_z(w) - wide.J_z(Long::initial()))) < 1e-18);
}
