// Stages of rotations side by side take the steps that they take one by one.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <type_traits>

#include <groups/driven_2.hpp>
#include <groups/one_by_one_2.hpp>
#include <groups/one_by_one_3.hpp>
#include <groups/one_by_one_4.hpp>
#include <groups/one_by_one_5.hpp>
#include <groups/one_by_one_c.hpp>
#include <groups/one_by_one_d.hpp>
#include <groups/one_by_one_s.hpp>
#include <groups/spacecraft_2.hpp>
#include <groups/top_2.hpp>
#include <groups/top_3.hpp>
#include <groups/top_4.hpp>
#include <groups/top_5.hpp>
#include <groups/top_chebyshev.hpp>
#include <hvi/detail/groups/chart.hpp>
#include <hvi/detail/groups/lane_angles.hpp>

#include "tests/runtime/groups/groups.hpp"

using namespace hvi::generated;
using groups::Code;

namespace {

/// Compares both forms over so many steps of a size: states to rounding, and iterations but for
/// one or two, since the last ones are rounding.
template <class Lanes, class OneByOne>
void compare(double h, int steps) {
    Lanes lanes;
    OneByOne one_by_one;
    auto x = Lanes::initial();
    auto y = OneByOne::initial();
    int more = 0;
    for (int i = 0; i < steps; ++i) {
        const hvi::Status first = lanes.step(x, h), second = one_by_one.step(y, h);
        REQUIRE(first.ok());
        REQUIRE(second.ok());
        more += first.iterations - second.iterations;
        CHECK(groups::distance<Lanes, OneByOne>(x, y) < 2e-15 * (i + 10));
    }
    CHECK(std::abs(more) <= steps / 2);
}

/// Returns the mean number of sweeps in so many steps.
template <class Stepper>
double sweeps(double h, int steps) {
    Stepper stepper;
    auto x = Stepper::initial();
    int all = 0;
    for (int i = 0; i < steps; ++i) {
        const hvi::Status status = stepper.step(x, h);
        REQUIRE(status.ok());
        all += status.iterations;
    }
    return static_cast<double>(all) / steps;
}

/// Takes a step that fails, and expects that the state keeps its bits.
template <class Stepper>
Code refused(Stepper stepper, const typename Stepper::State& x, double h) {
    auto y = x;
    const hvi::Status status = stepper.step(y, h);
    CHECK(groups::same_bits<Stepper>(x, y));
    return status.code();
}

}  // namespace

TEST_CASE("two to five stages, with an orbit, with a time: both forms take the same steps") {
    compare<TopGauss2, OneByOne2>(0.1, 100);
    compare<TopGauss3, OneByOne3>(0.1, 100);
    compare<TopGauss4, OneByOne4>(0.1, 100);
    compare<TopGauss5, OneByOne5>(0.1, 100);
    compare<TopChebyshev3, OneByOneC>(0.1, 100);
    compare<Spacecraft2, OneByOneS>(0.1, 100);
    compare<DrivenGauss2, OneByOneD>(0.1, 100);
}

TEST_CASE("steps of more stages begin nearer to their solution, and take fewer sweeps") {
    // NOTE: 14.2, 13.1, 12.0 and 10.5. With xi' = Omega in place of T^-1 Omega at the start they
    // are 14.2, 13.7, 13.6 and 13.9.
    CHECK(sweeps<TopGauss3>(0.1, 200) < sweeps<TopGauss2>(0.1, 200) - 0.9);
    CHECK(sweeps<TopGauss4>(0.1, 200) < sweeps<TopGauss3>(0.1, 200) - 0.9);
    CHECK(sweeps<TopGauss5>(0.1, 200) < sweeps<TopGauss4>(0.1, 200) - 0.5);
    CHECK(sweeps<OneByOne4>(0.1, 200) < sweeps<OneByOne2>(0.1, 200) - 1.8);
}

TEST_CASE("steps that change in size, and go back, agree as well") {
    TopGauss4 lanes;
    OneByOne4 one_by_one;
    auto x = TopGauss4::initial();
    auto y = OneByOne4::initial();
    for (const double h : {0.1, 0.1, 0.1, 0.25, 0.25, -0.1, -0.1, -0.1, -0.1, 0.05}) {
        REQUIRE(lanes.step(x, h).ok());
        REQUIRE(one_by_one.step(y, h).ok());
        CHECK(groups::distance<TopGauss4, OneByOne4>(x, y) < 2e-14);
    }
}

TEST_CASE("Newton's method takes over from stages side by side") {
    // Near the lowest point gravity is a stiff spring of frequency 100 and more.
    TopGauss4::Parameters stiff;
    stiff.centre = {0, 0, 1};
    stiff.g = 1e5;
    OneByOne4::Parameters same;
    same.centre = stiff.centre;
    same.g = stiff.g;
    TopGauss4 lanes(stiff);
    OneByOne4 one_by_one(same);
    auto x = TopGauss4::initial();
    x.R = {1, 0, 0, 0, -1, 0, 0, 0, -1};
    x.L = {1e-3, -2e-3, 1e-3};
    auto y = OneByOne4::initial();
    y.R = x.R;
    y.L = x.L;
    const double energy = lanes.energy(x), J = lanes.J_z(x);
    for (int i = 0; i < 100; ++i) {
        REQUIRE(lanes.step(x, 0.1).ok());
        REQUIRE(one_by_one.step(y, 0.1).ok());
        CHECK(groups::distance<TopGauss4, OneByOne4>(x, y) < 1e-11);
    }
    CHECK(std::abs(lanes.energy(x) - energy) < 1e-9 * std::abs(energy));
    CHECK(std::abs(lanes.J_z(x) - J) < 1e-15);
}

TEST_CASE("what fails side by side leaves the state as it was") {
    auto x = TopGauss4::initial();
    // It spins by 3 in a unit of time about an axis that gravity does not turn.
    TopGauss4::Parameters free;
    free.g = 0;
    x.L = {0, 0, 9};
    CHECK(refused(TopGauss4(free), x, 2.2) == Code::outside_chart);
    CHECK(refused(TopGauss4(free), x, 1e6) == Code::outside_chart);
    TopGauss4::Parameters infinite;
    infinite.g = std::numeric_limits<double>::infinity();
    CHECK(refused(TopGauss4(infinite), TopGauss4::initial(), 0.1) == Code::not_finite);
    x.L[1] = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused(TopGauss4(), x, 0.1) == Code::not_finite);
}

TEST_CASE("angles on both sides of the series, one of them or all") {
    using Lane = hvi::Lanes<double, 3>;
    typename Lane::Row squares{};
    for (const auto& y :
         {std::array{0.0, 1e-9, 1.0}, std::array{3.9, 4.0, 4.1}, std::array{20.0, 0.5, 39.0}}) {
        for (std::size_t i = 0; i < 3; ++i) { squares.set(i, y[i]); }
        const auto c = angle_functions(Lane(squares));
        typename Lane::Row c1, c2, c3;
        c.c1.store(c1);
        c.c2.store(c2);
        c.c3.store(c3);
        for (std::size_t i = 0; i < 3; ++i) {
            const long double a = std::sqrt(static_cast<long double>(y[i]));
            const bool is_small = a < 1e-3L;
            CHECK(std::abs(c1[i] - static_cast<double>(is_small ? 1 - a * a / 6
                                                                : std::sin(a) / a)) < 4e-16);
            CHECK(std::abs(c2[i] - static_cast<double>(is_small ? 0.5L - a * a / 24
                                                                : 2 * std::pow(std::sin(a / 2) / a,
                                                                               2.0L))) < 4e-16);
            CHECK(std::abs(c3[i] - static_cast<double>(is_small ? 1 / 6.0L - a * a / 120
                                                                : (a - std::sin(a)) /
                                                                      (a * a * a))) < 4e-16);
        }
    }
}
