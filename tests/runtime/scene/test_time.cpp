// Hamiltonians that depend on the time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <hvi/generic_stepper.hpp>
#include <scene/driven_gauss.hpp>
#include <scene/driven_lobatto.hpp>
#include <scene/driven_verlet.hpp>
#include <scene/fading_gauss.hpp>
#include <scene/fading_lanes.hpp>
#include <scene/fading_verlet.hpp>
#include <scene/fading_yoshida.hpp>
#include <scene/fitted_explicit.hpp>
#include <scene/fitted_explicit_constant.hpp>
#include <scene/fitted_shaken.hpp>
#include <scene/fitted_shaken_constant.hpp>
#include <scene/fitted_swept.hpp>
#include <scene/fitted_swept_constant.hpp>
#include <scene/moving_shaken.hpp>
#include <scene/moving_shaken_constant.hpp>
#include <scene/shaken_gauss.hpp>
#include <scene/shaken_newton.hpp>
#include <scene/shaken_trig3.hpp>

#include "scenes.hpp"
#include "tests/runtime/run/printed_tableaux.hpp"

using namespace hvi::generated;
using namespace printed;

namespace {

using Table = hvi::GenericStepper<double>::Vector;
using Oracle = hvi::GenericStepper<double>;

// The autonomous systems of twice the dimension: s is a coordinate, H + e their Hamiltonian.

/// H = p^2/2 - cos(q) - a q cos(w t), a = 1/2, w = 2/3.
Oracle driven(const hvi::Coefficients<double>& method) {
    return {method,
            [](const Table& q, const Table&, Table& out) {
                out = {std::sin(q[0]) - 0.5 * std::cos(2 * q[1] / 3),
                       q[0] * std::sin(2 * q[1] / 3) / 3};
            },
            [](const Table&, const Table& p, Table& out) {
                out = {p[0], 1.0};
            }};
}

/// H = (p - a sin(t))^2/2 + q^4/4, a = 1/2.
Oracle shaken(const hvi::Coefficients<double>& method) {
    return {method,
            [](const Table& q, const Table& p, Table& out) {
                out = {q[0] * q[0] * q[0], -(p[0] - 0.5 * std::sin(q[1])) * 0.5 * std::cos(q[1])};
            },
            [](const Table& q, const Table& p, Table& out) {
                out = {p[0] - 0.5 * std::sin(q[1]), 1.0};
            }};
}

template <class Stepper>
void compare(const Oracle& oracle, double h) {
    Stepper stepper;
    typename Stepper::State x;
    x.q = {1.0};
    x.p = {0.25};
    x.t = 0.5;
    Oracle::State y{{1.0, 0.5}, {0.25, 0.0}};
    for (int i = 0; i < 300; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(oracle.step(y, h).ok());

        REQUIRE(std::abs(x.q[0] - y.q[0]) + std::abs(x.p[0] - y.p[0]) < 1e-11);
        REQUIRE(std::abs(x.t - y.q[1]) < 1e-12);
    }
    CHECK(x.t == 0.5 + 300 * h);  // compensated
}

template <class Stepper>
void keeps_its_promises() {
    Stepper stepper;
    typename Stepper::State x;
    x.q = {1.0};
    x.p = {0.25};
    for (int i = 0; i < 3; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    typename Stepper::State edited = x;
    edited.t += 1.0;
    typename Stepper::State fresh = edited;
    REQUIRE(stepper.step(edited, 0.1).ok());
    REQUIRE(Stepper().step(fresh, 0.1).ok());
    CHECK(edited.q == fresh.q);
    CHECK(edited.p == fresh.p);
    CHECK(edited.t == fresh.t);

    typename Stepper::State lost = x;
    lost.t = std::numeric_limits<double>::infinity();
    CHECK_FALSE(stepper.step(lost, 0.1).ok());
    CHECK(lost.q == x.q);
    CHECK(lost.p == x.p);
    const typename Stepper::State before = x;
    REQUIRE(stepper.step(x, 0.0).ok());
    CHECK(x.t == before.t);
    CHECK_FALSE(stepper.step(x, std::numeric_limits<double>::quiet_NaN()).ok());
    CHECK(x.t == before.t);
}

/// Compares a stepper with a parameter, at one value, with a stepper with constants for this value.
template <class Stepper, class Constant>
void compare_at(double parameter) {
    Stepper stepper({}, parameter);
    Constant constant;
    typename Stepper::State x;
    x.q = {1.0};
    x.p = {0.25};
    x.t = 0.5;
    typename Constant::State y;
    y.q = x.q;
    y.p = x.p;
    y.t = x.t;
    for (int i = 0; i < 200; ++i) {
        REQUIRE(stepper.step(x, 0.1).ok());
        REQUIRE(constant.step(y, 0.1).ok());
        REQUIRE(std::abs(x.q[0] - y.q[0]) + std::abs(x.p[0] - y.p[0]) < 1e-12);
        REQUIRE(x.t == y.t);
    }
}

}  // namespace

TEST_CASE("a method with a parameter has the times of its stages") {
    compare_at<FittedShaken, FittedShakenConstant>(0.5);
    compare_at<FittedSwept, FittedSweptConstant>(0.5);
    compare_at<FittedExplicit, FittedExplicitConstant>(0.5);
    compare_at<MovingShaken, MovingShakenConstant>(0.4);

    // Nodes that do not depend on the parameter, and one that does.
    const FittedShaken::Coefficients coefficients = FittedShaken({}, 0.5).coefficients();
    const auto& fixed = coefficients.c;
    CHECK(fixed[0] == 0.0);
    CHECK(fixed[1] == 1.0 / 3);
    CHECK(fixed[2] == 2.0 / 3);
    CHECK(fixed[3] == 1.0);
    CHECK(MovingShaken({}, 0.4).coefficients().c[1] == 0.4);

    // Where there is no method the time stays as well.
    FittedShaken none({}, 9.42477796076938);  // 3 pi
    FittedShaken::State x;
    x.t = 0.5;
    CHECK(none.step(x, 0.1).code() == hvi::Status::Code::pole);
    CHECK(x.t == 0.5);
}

TEST_CASE("steps in time agree with those of the autonomous system of twice the dimension") {
    compare<DrivenGauss>(driven(gauss), 0.1);
    compare<DrivenLobatto>(driven(lobatto), 0.1);
    compare<DrivenVerlet>(driven(verlet), 0.1);
    compare<ShakenGauss>(shaken(gauss), 0.1);
    compare<ShakenNewton>(shaken(gauss), 0.1);
    compare<ShakenTrig3>(shaken(trig), 0.1);
}

TEST_CASE("the time belongs to the state") {
    keeps_its_promises<DrivenGauss>();
    keeps_its_promises<DrivenLobatto>();
    keeps_its_promises<DrivenVerlet>();
    keeps_its_promises<ShakenGauss>();
    keeps_its_promises<ShakenNewton>();
}

TEST_CASE("the energy at a time") {
    DrivenGauss::State x;
    x.q = {2.0};
    x.p = {1.0};
    x.t = 3.0;
    CHECK(DrivenGauss().energy(x) ==
          Approx(0.5 - std::cos(2.0) - 0.5 * 2.0 * std::cos(2.0)).epsilon(1e-15));
}

TEMPLATE_TEST_CASE("a step to a time that is no number leaves the state", "", FadingGauss,
                   FadingLanes, FadingVerlet, FadingYoshida) {
    // There is no force so late, and q would go to 1e8: the time alone overflows.
    TestType stepper;
    typename TestType::State x;
    x.q = {1.0};
    x.p = {1e-300};
    x.t = 1.7e308;
    const auto before = x;
    const hvi::Status status = stepper.step(x, 1e308);
    CHECK(status.code() == hvi::Status::Code::not_finite);
    CHECK(x.q == before.q);
    CHECK(x.p == before.p);
    CHECK(x.t == before.t);
    x.t = 1.0;
    TestType fresh;
    auto y = x;
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(fresh.step(y, 0.1).ok());
    CHECK(x.q == y.q);
}
