// The orders of methods in natural charts are those in flat spaces.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <groups/driven_2.hpp>
#include <groups/spacecraft_2.hpp>
#include <groups/top_2.hpp>
#include <groups/top_3.hpp>
#include <groups/top_4.hpp>
#include <groups/top_chebyshev.hpp>
#include <groups/top_lobatto.hpp>
#include <groups/top_midpoint.hpp>
#include <groups/top_trig.hpp>
#include <groups/top_verlet.hpp>
#include <groups/top_yoshida.hpp>

#include "tests/runtime/groups/groups.hpp"

using namespace hvi::generated;

namespace {

template <class Stepper, class Reference>
double order(double time, int count, int count_of_reference) {
    const auto exact = groups::end<Reference>(time, count_of_reference);
    const auto coarse = groups::end<Stepper>(time, count);
    const auto fine = groups::end<Stepper>(time, 2 * count);
    return std::log2(groups::distance<Stepper, Reference>(coarse, exact) /
                     groups::distance<Stepper, Reference>(fine, exact));
}

template <class Stepper>
double order_on_top(int count) {
    return order<Stepper, TopGauss4>(2, count, 400);
}

}  // namespace

TEST_CASE("a body without symmetry in a potential: order 2, 4 and 6") {
    CHECK(order_on_top<TopMidpoint>(64) == Approx(2).margin(0.1));
    CHECK(order_on_top<TopVerlet>(64) == Approx(2).margin(0.1));
    CHECK(order_on_top<TopTrig3>(64) == Approx(2).margin(0.1));
    CHECK(order_on_top<TopGauss2>(16) == Approx(4).margin(0.2));
    CHECK(order_on_top<TopChebyshev3>(16) == Approx(4).margin(0.2));
    CHECK(order_on_top<TopLobatto3>(16) == Approx(4).margin(0.3));
    CHECK(order_on_top<TopYoshida>(64) == Approx(4).margin(0.2));
    CHECK(order_on_top<TopGauss3>(12) == Approx(6).margin(0.4));
}

TEST_CASE("an orbit beside a rotation, and a time beside both") {
    CHECK(order<Spacecraft2, Spacecraft2>(1, 16, 1024) == Approx(4).margin(0.2));
    CHECK(order<DrivenGauss2, DrivenGauss2>(1, 16, 1024) == Approx(4).margin(0.2));
}
