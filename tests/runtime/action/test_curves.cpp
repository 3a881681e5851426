// The discrete Hamiltonian (4.2) of the general Galerkin form and of Lagrangians: a closed form,
// and Proposition 4.1.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <action/composed_gauss_double.hpp>
#include <action/composed_lagrangian.hpp>
#include <action/curve_23_kepler.hpp>
#include <action/curve_double.hpp>
#include <action/curve_oscillator.hpp>
#include <action/gauss_double.hpp>
#include <action/lagrangian_23_double.hpp>
#include <action/lagrangian_double.hpp>
#include <action/lagrangian_oscillator.hpp>
#include <action/positions_23_kepler.hpp>
#include <catch2/catch.hpp>

using namespace hvi::generated;

namespace {

/// (4.2) for H = (p^2 + q^2)/2 + 3, one velocity V and the nodes of gauss:2, at which the sums of
/// b_i c_i and b_i c_i^2 are 1/2 and 1/3. All P_i are V, so that H_d^+ is the value of
///
///     p (q + h V) - h V^2/2 + h/2 sum_i b_i (q + h c_i V)^2 + 3 h
///
/// where its derivative by V is 0.
double of_oscillator(double q, double p, double h) {
    const double V = (p + h * q / 2) / (1 - h * h / 3);
    const double squares = q * q + h * q * V + h * h * V * V / 3;
    return p * (q + h * V) - h * V * V / 2 + h / 2 * squares + 3 * h;
}

template <class Stepper>
void check_oscillator() {
    for (const double h : {0.1, 0.5, -0.5}) {
        Stepper stepper;
        typename Stepper::State x{{0.75}, {-1.25}};
        const double q = x.q[0];
        REQUIRE(stepper.step(x, h).ok());
        CHECK(stepper.generating_function() == Approx(of_oscillator(q, x.p[0], h)).epsilon(1e-14));
    }
}

template <class Vector>
double distance(const Vector& a, const Vector& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        largest = std::max(largest, std::abs(a[k] - b[k]));
    }
    return largest;
}

/// Compares a run by an H with one by its L. Each step of the latter begins where the step of the
/// former does, bit for bit, so that chaos does not separate them.
template <class OfH, class OfL>
void check_proposition(double h) {
    OfH hamiltonian;
    OfL lagrangian;
    typename OfH::State x{{1.0, 0.8}, {0.3, -0.2}};
    for (int i = 0; i < 50; ++i) {
        typename OfL::State y{x.q, x.p};
        REQUIRE(hamiltonian.step(x, h).ok());
        REQUIRE(lagrangian.step(y, h).ok());
        CHECK(distance(x.q, y.q) < 2e-14);
        CHECK(distance(x.p, y.p) < 5e-14);
        CHECK(std::abs(hamiltonian.generating_function() - lagrangian.generating_function()) <
              5e-14);
    }
}

}  // namespace

TEST_CASE("the oscillator by one velocity and two nodes has the H_d^+ of (4.2)") {
    check_oscillator<CurveOscillator>();
    check_oscillator<LagrangianOscillator>();
}

TEST_CASE("Proposition 4.1: the action of a Lagrangian is that of its Hamiltonian") {
    check_proposition<GaussDouble, LagrangianDouble>(0.02);
    check_proposition<CurveDouble, Lagrangian23Double>(0.02);
    check_proposition<ComposedGaussDouble, ComposedLagrangian>(0.02);
}

TEST_CASE("over a run too") {
    GaussDouble hamiltonian;
    LagrangianDouble lagrangian;
    GaussDouble::State x = GaussDouble::initial();
    LagrangianDouble::State y = LagrangianDouble::initial();
    for (int i = 0; i < 50; ++i) {
        REQUIRE(hamiltonian.step(x, 0.01).ok());
        REQUIRE(lagrangian.step(y, 0.01).ok());
        CHECK(std::abs(hamiltonian.generating_function() - lagrangian.generating_function()) <
              2e-13);
        CHECK(std::abs(hamiltonian.action() - lagrangian.action()) < 2e-13);
    }
}

TEST_CASE("steps with an action are those by positions alone") {
    Curve23Kepler curve;
    Positions23Kepler positions;
    Curve23Kepler::State x = Curve23Kepler::initial();
    Positions23Kepler::State y = Positions23Kepler::initial();
    for (int i = 0; i < 50; ++i) {
        REQUIRE(curve.step(x, 0.05).ok());
        REQUIRE(positions.step(y, 0.05).ok());
        CHECK(distance(x.q, y.q) < 1e-12);
        CHECK(distance(x.p, y.p) < 1e-12);
    }
}
