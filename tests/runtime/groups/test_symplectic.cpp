// The derivative D of steps in canonical coordinates of both ends: D^T J D = J.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <tuple>

#include <driver/dual.hpp>
#include <driver/edge_symplectic.hpp>
#include <groups/spacecraft_2.hpp>
#include <groups/top_2.hpp>
#include <groups/top_chebyshev.hpp>
#include <groups/top_lobatto.hpp>
#include <groups/top_midpoint.hpp>
#include <groups/top_newton.hpp>
#include <groups/top_trig.hpp>
#include <groups/top_verlet.hpp>

#include "tests/runtime/groups/groups.hpp"

using namespace hvi::generated;

namespace {

/// For each of 10 steps of this size.
template <class Stepper>
double defect(double h) {
    const auto seen = hvi::driver::SymplecticDefect<Stepper>().of(Stepper::initial(), h, 10);
    REQUIRE(seen.has_value());
    return *seen;
}

using Of3 = hvi::driver::Dual<6>;
using Of6 = hvi::driver::Dual<12>;
constexpr double rounding = 5e-14;

}  // namespace

TEST_CASE("steps in charts that move with the state are symplectic") {
    CHECK(defect<BasicTopMidpoint<Of3>>(0.2) < rounding);
    CHECK(defect<BasicTopGauss2<Of3>>(0.2) < rounding);
    CHECK(defect<BasicTopChebyshev3<Of3>>(0.2) < rounding);
    CHECK(defect<BasicTopLobatto3<Of3>>(0.2) < rounding);
    CHECK(defect<BasicTopTrig3<Of3>>(0.2) < rounding);
    CHECK(defect<BasicTopVerlet<Of3>>(0.2) < rounding);
    CHECK(defect<BasicTopNewton<Of3>>(0.2) < rounding);
    CHECK(defect<BasicSpacecraft2<Of6>>(0.2) < rounding);
}
