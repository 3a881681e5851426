// Steppers of scenes: what they compute, keep and refuse.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <limits>
#include <type_traits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/generic_stepper.hpp>
#include <scene/gauss_2_henon_heiles.hpp>
#include <scene/lobatto_3_kepler.hpp>
#include <scene/mass_matrix.hpp>
#include <scene/newton_double_pendulum.hpp>
#include <scene/newton_kepler.hpp>
#include <scene/pairs_of_mass_matrix.hpp>
#include <scene/trig3_pendulum.hpp>
#include <scene/verlet_kepler.hpp>

#include "scenes.hpp"
#include "tests/runtime/run/printed_tableaux.hpp"

using namespace hvi::generated;
using namespace printed;

double end_in_second_unit();

namespace {

/// The formulas as the paper prints them, with the scene's own H.
template <class Stepper>
hvi::GenericStepper<double> by_the_table(const hvi::Coefficients<double>& method) {
    using Table = hvi::GenericStepper<double>::Vector;
    using Vector = typename Stepper::Vector;
    const typename Stepper::System system{typename Stepper::Parameters{}};
    const auto slope = [=](const Table& q, const Table& p, Table& out, bool by_q) {
        Vector at_q{}, at_p{}, dq{}, dp{};
        std::copy(q.begin(), q.end(), at_q.begin());
        std::copy(p.begin(), p.end(), at_p.begin());
        scenes::gradient(system, at_q, at_p, dq, dp);
        const Vector& result = by_q ? dq : dp;
        out.assign(result.begin(), result.end());
    };
    return {method, [=](const Table& q, const Table& p, Table& out) { slope(q, p, out, true); },
            [=](const Table& q, const Table& p, Table& out) { slope(q, p, out, false); }};
}

template <class Stepper>
void compare(const hvi::Coefficients<double>& method, double h, int steps, double bound) {
    const hvi::GenericStepper<double> oracle = by_the_table<Stepper>(method);
    Stepper stepper;
    typename Stepper::State x = Stepper::initial();
    hvi::GenericStepper<double>::State y{{x.q.begin(), x.q.end()}, {x.p.begin(), x.p.end()}};
    for (int i = 0; i < steps; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(oracle.step(y, h).ok());
        for (std::size_t k = 0; k < x.q.size(); ++k) {
            REQUIRE(std::abs(x.q[k] - y.q[k]) <= bound);
            REQUIRE(std::abs(x.p[k] - y.p[k]) <= bound);
        }
    }
}

/// The largest change of the energy over so many steps.
template <class Stepper>
double energy_error(double h, int steps) {
    Stepper stepper;
    typename Stepper::State x = Stepper::initial();
    const double energy = stepper.energy(x);
    double error = 0.0;
    for (int i = 0; i < steps; ++i) {
        if (!stepper.step(x, h).ok()) { return std::numeric_limits<double>::infinity(); }
        error = std::max(error, std::abs(stepper.energy(x) - energy));
    }
    return error;
}

struct KeepsPromises {
    template <class Stepper>
    void operator()() const {
        const double h = 1e-3;
        Stepper stepper;
        typename Stepper::State x = Stepper::initial();
        const typename Stepper::State start = x;

        REQUIRE(stepper.step(x, 0.0).ok());
        CHECK(scenes::same_bits(x, start));
        REQUIRE_FALSE(stepper.step(x, std::numeric_limits<double>::infinity()).ok());
        CHECK(scenes::same_bits(x, start));

        for (int i = 0; i < 3; ++i) { REQUIRE(stepper.step(x, h).ok()); }
        CHECK_FALSE(scenes::same_bits(x, start));
        typename Stepper::State edited = x;
        edited.q[0] += 1e-9;
        typename Stepper::State fresh = edited;
        REQUIRE(stepper.step(edited, h).ok());
        REQUIRE(Stepper().step(fresh, h).ok());
        CHECK(scenes::same_bits(edited, fresh));

        typename Stepper::State lost = start;
        lost.p[0] = std::numeric_limits<double>::quiet_NaN();
        const typename Stepper::State lost_before = lost;
        CHECK_FALSE(stepper.step(lost, h).ok());
        CHECK(scenes::same_bits(lost, lost_before));

        typename Stepper::State back = start;
        REQUIRE(stepper.step(back, h).ok());
        REQUIRE(stepper.step(back, -h).ok());
        CHECK(scenes::distance_of_states(back, start) < 1e-12 * (1 + size(start)));
    }

    template <class State>
    static double size(const State& x) {
        return scenes::distance_of_states(x, State{});
    }
};

}  // namespace

TEST_CASE("steps of scenes agree with the formulas of the paper") {
    compare<Gauss2HenonHeiles>(gauss, 0.1, 200, 2e-13);
    compare<Lobatto3Kepler>(lobatto, 0.01, 200, 2e-13);
    compare<Trig3Pendulum>(trig, 0.1, 200, 2e-13);
}

TEST_CASE("every scene's stepper keeps its promises") { scenes::for_each(KeepsPromises{}); }

TEST_CASE("the energies at the start, computed by hand") {
    CHECK(Kepler().energy(Kepler::initial()) == Approx(-0.5).epsilon(1e-15));
    CHECK(HenonHeiles().energy(HenonHeiles::initial()) == Approx(0.125).epsilon(1e-15));
    CHECK(Nonseparable().energy(Nonseparable::initial()) == Approx(5.0).epsilon(1e-15));
    CHECK(Pendulum().energy(Pendulum::initial()) == Approx(-std::cos(1.5)).epsilon(1e-15));
    CHECK(Qp().energy(Qp::initial()) == 1.0);
}

TEST_CASE("energy and invariants over long runs") {
    CHECK(energy_error<Kepler>(0.05, 4000) < 2e-11);
    CHECK(energy_error<HenonHeiles>(0.25, 4000) < 1e-8);
    CHECK(energy_error<Pendulum>(0.1, 4000) < 1e-8);
    CHECK(energy_error<DoublePendulum>(0.01, 2000) < 1e-9);

    OuterSolarSystem stepper;
    OuterSolarSystem::State x = OuterSolarSystem::initial();
    const OuterSolarSystem::State start = x;
    for (int i = 0; i < 200; ++i) { REQUIRE(stepper.step(x, 300.0).ok()); }
    CHECK(stepper.momentum_x(x) == Approx(stepper.momentum_x(start)).epsilon(1e-13));
    CHECK(stepper.angular_momentum_z(x) ==
          Approx(stepper.angular_momentum_z(start)).epsilon(1e-13));
    CHECK(stepper.energy(x) == Approx(stepper.energy(start)).epsilon(1e-11));

    PointVortices vortices;
    PointVortices::State y = PointVortices::initial();
    const PointVortices::State before = y;
    for (int i = 0; i < 500; ++i) { REQUIRE(vortices.step(y, 0.05).ok()); }
    CHECK(vortices.impulse_x(y) == Approx(vortices.impulse_x(before)).margin(1e-13));
    CHECK(vortices.angular_impulse(y) == Approx(vortices.angular_impulse(before)).epsilon(1e-12));
}

TEST_CASE("the exact solutions of the oscillator and of q p") {
    // Gauss with two stages turns by 2 atan((z/2)/(1 - z^2/12)) in a step (Section 6 of the paper).
    HarmonicOscillator stepper;
    HarmonicOscillator::State x = HarmonicOscillator::initial();
    for (int i = 0; i < 100; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    const double angle = 100 * 2 * std::atan(0.05 / (1 - 0.01 / 12));
    CHECK(x.q[0] == Approx(std::cos(angle)).epsilon(1e-13));
    CHECK(x.p[0] == Approx(-std::sin(angle)).epsilon(1e-13));

    Qp flow;
    Qp::State y = Qp::initial();
    for (int i = 0; i < 30; ++i) { REQUIRE(flow.step(y, 0.1).ok()); }
    CHECK(y.q[0] * y.p[0] == Approx(1.0).epsilon(1e-14));
    CHECK(y.q[0] == Approx(std::exp(3.0)).epsilon(1e-4));
}

TEST_CASE("parameters are arguments") {
    HarmonicOscillator::Parameters parameters;
    CHECK(parameters.omega == 1.0);
    parameters.omega = 3.0;
    HarmonicOscillator stepper{parameters};
    HarmonicOscillator::State x = HarmonicOscillator::initial(parameters);
    CHECK(stepper.energy(x) == Approx(4.5));
    Kepler::Parameters flat;
    flat.ecc = 0.0;
    CHECK(Kepler::initial(flat).q[0] == 1.0);
    CHECK(Kepler::initial(flat).p[1] == 1.0);
    OuterSolarSystem::Parameters bodies;
    CHECK(bodies.m.size() == 6);
    CHECK(bodies.m[5] == 1.0 / 1.3e8);
}

TEST_CASE("Newton's method and the fixed point go to the same values") {
    NewtonKepler newton;
    Kepler fixed;
    auto x = NewtonKepler::initial();
    auto y = Kepler::initial();
    NewtonDoublePendulum other_newton;
    DoublePendulum other_fixed;
    auto u = NewtonDoublePendulum::initial();
    auto v = DoublePendulum::initial();
    for (int i = 0; i < 50; ++i) {
        REQUIRE(newton.step(x, 0.05).ok());
        REQUIRE(fixed.step(y, 0.05).ok());
        REQUIRE(other_newton.step(u, 0.01).ok());
        REQUIRE(other_fixed.step(v, 0.01).ok());
    }
    CHECK(scenes::distance_of_states(x, y) < 1e-12);
    CHECK(scenes::distance_of_states(u, v) < 1e-12);
}

TEST_CASE("an inverse mass matrix that is not diagonal, and a term that is linear in p") {
    MassMatrix eliminated;
    PairsOfMassMatrix pairs;
    MassMatrix::State x{{0.5, -0.25}, {0.125, 1.0}};
    PairsOfMassMatrix::State y{{0.5, -0.25}, {0.125, 1.0}};
    for (int i = 0; i < 100; ++i) {
        REQUIRE(eliminated.step(x, 0.1).ok());
        REQUIRE(pairs.step(y, 0.1).ok());
    }
    CHECK(scenes::distance(x.q, y.q) + scenes::distance(x.p, y.p) < 1e-11);
}

TEST_CASE("float and long double") {
    BasicKepler<float> single;
    auto x = BasicKepler<float>::initial();
    BasicKepler<long double> extended;
    auto y = BasicKepler<long double>::initial();
    Kepler stepper;
    auto z = Kepler::initial();
    for (int i = 0; i < 100; ++i) {
        REQUIRE(single.step(x, 0.05F).ok());
        REQUIRE(extended.step(y, 0.05L).ok());
        REQUIRE(stepper.step(z, 0.05).ok());
    }
    CHECK(static_cast<double>(x.q[0]) == Approx(z.q[0]).margin(2e-4));
    CHECK(static_cast<double>(y.q[0]) == Approx(z.q[0]).margin(1e-12));
}

TEST_CASE("a collision ends in a status, not in a state") {
    Kepler stepper;
    Kepler::State x{{1.0, 0.0}, {0.0, 0.0}};  // falls into the sun at t = pi/sqrt(8)
    hvi::Status status;
    int steps = 0;
    Kepler::State last = x;
    while (status.ok() && steps < 1000) {
        last = x;
        status = stepper.step(x, 0.05);
        ++steps;
    }
    if (!status.ok()) { CHECK(scenes::same_bits(x, last)); }
    Kepler::State at_sun{{0.0, 0.0}, {0.0, 0.0}};
    CHECK_FALSE(stepper.step(at_sun, 0.05).ok());
    VerletKepler explicit_stepper;
    VerletKepler::State there{{0.0, 0.0}, {0.0, 0.0}};
    CHECK_FALSE(explicit_stepper.step(there, 0.05).ok());
    CHECK(there.q[0] == 0.0);
}

TEST_CASE("headers of scenes in two translation units") {
    Kepler stepper;
    Kepler::State x = Kepler::initial();
    for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, 0.05).ok()); }
    CHECK(end_in_second_unit() == x.q[0]);
}
