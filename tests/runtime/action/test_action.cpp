// The discrete Hamiltonian of a step and the discrete action of a run: closed forms, Taylor series,
// the exact flow, and when they begin anew.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <limits>

#include <action/composed_curve_rooted.hpp>
#include <action/composed_lagrangian.hpp>
#include <action/composed_rooted.hpp>
#include <action/curve_23_kepler.hpp>
#include <action/curve_rooted.hpp>
#include <action/curve_shaken.hpp>
#include <action/gauss_oscillator.hpp>
#include <action/gauss_pendulum.hpp>
#include <action/gauss_qp.hpp>
#include <action/gauss_shaken.hpp>
#include <action/lagrangian_rooted.hpp>
#include <action/lobatto_kepler.hpp>
#include <action/midpoint_pendulum.hpp>
#include <action/verlet_driven.hpp>
#include <action/verlet_oscillator.hpp>
#include <action/verlet_pendulum.hpp>
#include <action/yoshida_driven.hpp>
#include <action/yoshida_kepler.hpp>
#include <catch2/catch.hpp>

using namespace hvi::generated;

namespace {

template <class Vector>
auto dot(const Vector& a, const Vector& b) {
    auto sum = a[0] * b[0];
    for (std::size_t k = 1; k < a.size(); ++k) { sum += a[k] * b[k]; }
    return sum;
}

/// H_d^+ of one step, and where it ends.
template <class Stepper>
struct OneStep {
    OneStep(const typename Stepper::State& start, double h) : end(start) {
        Stepper stepper;
        REQUIRE(stepper.step(end, h).ok());
        H = stepper.generating_function();
        CHECK(stepper.action() == H);
    }

    typename Stepper::State end;
    double H;
};

/// Returns the power of h with which a value falls.
double exponent(double at_h, double at_half_h) { return std::log2(std::abs(at_h / at_half_h)); }

// ---- the exact discrete Hamiltonian ----

/// q, p and the integral of p dq - H dt of one degree of freedom.
using Flow = std::array<double, 3>;

/// Solves by the classical Runge-Kutta method in many small steps, independently of our steppers.
/// The slopes are a function of the time and q and p.
template <class Slopes>
Flow flow(Slopes slopes, double q, double p, double t, double h) {
    constexpr int steps = 200;
    Flow y{q, p, 0.0};
    const double dt = h / steps;
    const auto moved = [&](double factor, const Flow& by) {
        return Flow{y[0] + factor * by[0], y[1] + factor * by[1], y[2] + factor * by[2]};
    };
    for (int i = 0; i < steps; ++i, t += dt) {
        const Flow k1 = slopes(t, y);
        const Flow k2 = slopes(t + dt / 2, moved(dt / 2, k1));
        const Flow k3 = slopes(t + dt / 2, moved(dt / 2, k2));
        const Flow k4 = slopes(t + dt, moved(dt, k3));
        for (std::size_t k = 0; k < 3; ++k) {
            y[k] += dt / 6 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k]);
        }
    }
    return y;
}

/// H_d^+ less (4.1) at (q_0, p_1) of the step. NOTE: the exact step from (q_0, p_0) ends at another
/// p; there (4.1) is p q less the integral, and its derivative by p is q.
template <class Stepper, class Slopes>
double error(Slopes slopes, const typename Stepper::State& start, double h) {
    const OneStep<Stepper> step(start, h);
    double t = 0;
    if constexpr (requires { start.t; }) { t = start.t; }
    const auto [q, p, integral] = flow(slopes, start.q[0], start.p[0], t, h);
    return step.H - (p * q - integral + q * (step.end.p[0] - p));
}

Flow pendulum(double, const Flow& y) {
    const auto [q, p, integral] = y;
    return {p, -std::sin(q), p * p - (p * p / 2 - std::cos(q))};
}

Flow driven(double t, const Flow& y) {
    const auto [q, p, integral] = y;
    const double force = std::cos(2 * t / 3) / 2;
    return {p, -std::sin(q) + force, p * p - (p * p / 2 - std::cos(q) - q * force)};
}

Flow shaken(double t, const Flow& y) {
    const auto [q, p, integral] = y;
    const double v = p - std::sin(t) / 2;
    return {v, -q * q * q, p * v - (v * v / 2 + q * q * q * q / 4)};
}

/// The Hamiltonian of rooted.toml: with m = 1 + q^2/4 and u = v + cos(t)/2, p is m u.
Flow rooted(double t, const Flow& y) {
    const auto [q, p, integral] = y;
    const double m = 1 + q * q / 4, u = p / m, v = u - std::cos(t) / 2;
    const double L = m * u * u / 2 + std::cos(q) - q * std::sqrt(t) / 2;
    return {v, q / 4 * u * u - std::sin(q) - std::sqrt(t) / 2, L};
}

/// The steps of yoshida:4, in parts of h.
std::array<double, 3> parts() {
    const double outer = 1 / (2 - std::cbrt(2.0));
    return {outer, 1 - 2 * outer, outer};
}

template <class Composed, class Stepper>
void check_composed() {
    typename Stepper::State x{{{0.75}, {-0.5}}, 0.25};
    const OneStep<Composed> step({{x.q, x.p}, x.t}, 0.2);
    Stepper stepper;
    for (const double part : parts()) { REQUIRE(stepper.step(x, part * 0.2).ok()); }
    CHECK(step.H == Approx(stepper.action()).epsilon(1e-14));
}

// ---- promises ----

/// Checks (3.13) for each step of a run.
template <class Stepper>
void check_run(typename Stepper::State x, double h) {
    Stepper stepper;
    double sum = 0.0;
    for (int i = 0; i < 40; ++i) {
        REQUIRE(stepper.step(x, i % 5 == 4 ? -h : h).ok());
        sum += dot(x.p, x.q) - stepper.generating_function();
        CHECK(stepper.action() == Approx(dot(x.p, x.q) - sum).margin(1e-13));
        if (i == 0) { CHECK(stepper.action() == stepper.generating_function()); }
    }
}

/// Whether the last step of `stepper`, from `before`, went on with the action so far.
template <class Stepper>
bool went_on(const Stepper& stepper, const typename Stepper::State& before, double action) {
    const double on = action + stepper.generating_function() - dot(before.p, before.q);
    REQUIRE(std::abs(on - stepper.generating_function()) > 1e-3);
    if (stepper.action() == stepper.generating_function()) { return false; }
    CHECK(stepper.action() == Approx(on).epsilon(1e-13));
    return true;
}

/// Checks that some calls leave both members unchanged, and that others restart the action.
template <class Stepper>
void check_promises(typename Stepper::State x, double h) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Stepper stepper;
    CHECK(std::isnan(stepper.generating_function()));
    CHECK(std::isnan(stepper.action()));
    for (int i = 0; i < 5; ++i) { REQUIRE(stepper.step(x, h).ok()); }
    const double H = stepper.generating_function();
    const double S = stepper.action();

    typename Stepper::State lost = x;
    lost.p[0] = std::numeric_limits<double>::quiet_NaN();
    REQUIRE(stepper.step(x, 0.0).ok());
    REQUIRE_FALSE(stepper.step(x, infinity).ok());
    REQUIRE_FALSE(stepper.step(lost, h).ok());
    CHECK(stepper.generating_function() == H);
    CHECK(stepper.action() == S);
    typename Stepper::State before = x;
    REQUIRE(stepper.step(x, h / 2).ok());
    CHECK(went_on(stepper, before, S));

    const double later = stepper.action();
    x.q[0] = std::nextafter(x.q[0], 2.0);
    before = x;
    REQUIRE(stepper.step(x, h).ok());
    CHECK_FALSE(went_on(stepper, before, later));

    stepper.reset();
    CHECK(std::isnan(stepper.generating_function()));
    CHECK(std::isnan(stepper.action()));
    before = x;
    REQUIRE(stepper.step(x, h).ok());
    CHECK(stepper.action() == stepper.generating_function());
}

/// NOTE: the force has a square root of t: forward from t = 0.01, back to before 0. The state keeps
/// the bits of the end of the last good step.
template <class Composed, class Stepper>
void check_later_failure() {
    Stepper alone;
    typename Stepper::State y{{{0.75}, {0.5}}, 0.01};
    REQUIRE(alone.step(y, parts()[0] * 0.1).ok());
    REQUIRE_FALSE(alone.step(y, parts()[1] * 0.1).ok());

    Composed stepper;
    typename Composed::State x{{{0.75}, {0.5}}, 0.02};
    REQUIRE(stepper.step(x, -0.005).ok());
    REQUIRE(stepper.step(x, -0.005).ok());
    const double H = stepper.generating_function(), S = stepper.action();
    const typename Composed::State before = x;
    REQUIRE(std::abs(x.t - 0.01) < 1e-15);
    REQUIRE_FALSE(stepper.step(x, 0.1).ok());
    CHECK(x.q == before.q);
    CHECK(x.p == before.p);
    CHECK(x.t == before.t);
    CHECK(stepper.generating_function() == H);
    CHECK(stepper.action() == S);
    REQUIRE(stepper.step(x, 0.01).ok());
    CHECK(went_on(stepper, before, S));
}

}  // namespace

TEST_CASE("H = q p has H_d^+ = R(h) q_0 p_1, R being the function of stability") {
    const GaussQp::State start{{0.75}, {-1.25}};
    for (const double h : {0.1, 0.5, -0.5}) {
        const OneStep<GaussQp> step(start, h);
        const double R = (1 + h / 2 + h * h / 12) / (1 - h / 2 + h * h / 12);
        CHECK(step.H == Approx(R * start.q[0] * step.end.p[0]).epsilon(1e-15));
    }
}

// For d = 1 - h^2/2 the step has q_1 = (q_0 + h p_1)/d and p_0 = p_1 + h (q_0 + q_1)/2, and H_d^+
// is their integral; the 3 in H adds 3 h.
TEST_CASE("the oscillator with Stormer and Verlet's method") {
    const VerletOscillator::State start{{0.75}, {-1.25}};
    for (const double h : {0.1, 0.5, -0.5}) {
        const OneStep<VerletOscillator> step(start, h);
        const double q = start.q[0], p = step.end.p[0], d = 1 - h * h / 2;
        const double H = (q * p + h * p * p / 2) / d + h * q * q / 4 * (1 + 1 / d) + 3 * h;
        CHECK(step.H == Approx(H).epsilon(1e-14));
    }
}

// A rotation by theta has H_d^+ = q_0 p_1/cos(theta) + tan(theta) (q_0^2 + p_1^2)/2; here
// exp(i theta) is the Pade approximation to exp(i h).
TEST_CASE("the oscillator with gauss:2, which rotates") {
    const GaussOscillator::State start{{0.75}, {-1.25}};
    for (const double h : {0.1, 0.5, -0.5}) {
        const OneStep<GaussOscillator> step(start, h);
        const double theta = 2 * std::atan2(h / 2, 1 - h * h / 12);
        const double q = start.q[0], p = step.end.p[0];
        const double H = q * p / std::cos(theta) + std::tan(theta) * (q * q + p * p) / 2 + 3 * h;
        CHECK(step.H == Approx(H).epsilon(1e-14));
    }
}

// H = p^2/2 + U(q): with S = q p + sum_k h^k G_k in (2.7), k G_k is the coefficient of h^(k-1) in
// H(q + sum_j h^j dG_j/dp, p).
TEST_CASE("the Taylor series of the exact discrete Hamiltonian, up to the order of the method") {
    const GaussPendulum::State start{{0.75}, {-0.5}};
    const auto rest = [&](double h, int terms) {
        const OneStep<GaussPendulum> step(start, h);
        const double q = start.q[0], p = step.end.p[0];
        const double U = -std::cos(q), U1 = std::sin(q), U2 = std::cos(q), U3 = -U1;
        const std::array<double, 4> G{p * p / 2 + U, U1 * p / 2, (U1 * U1 + U2 * p * p) / 6,
                                      (5 * U1 * U2 * p + U3 * p * p * p) / 24};
        double sum = q * p;
        double power = h;
        for (int k = 0; k < terms; ++k, power *= h) {
            sum += power * G[static_cast<std::size_t>(k)];
        }
        return step.H - sum;
    };
    for (int terms = 0; terms <= 4; ++terms) {
        INFO(terms);
        const double found = exponent(rest(0.02, terms), rest(0.01, terms));
        CHECK(found == Approx(terms + 1).margin(0.1));
    }
}

TEST_CASE("from the exact discrete Hamiltonian H_d^+ differs by h^(order+1)") {
    const auto falls = [](auto error) { return exponent(error(0.06), error(0.03)); };
    const MidpointPendulum::State start{{0.75}, {-1.5}};
    CHECK(falls([&](double h) { return error<MidpointPendulum>(pendulum, start, h); }) ==
          Approx(3).margin(0.2));
    CHECK(falls([&](double h) { return error<VerletPendulum>(pendulum, start, h); }) ==
          Approx(3).margin(0.2));
    CHECK(falls([&](double h) { return error<GaussPendulum>(pendulum, start, h); }) ==
          Approx(5).margin(0.2));
    const VerletDriven::State at_time{{{0.75}, {-1.5}}, 0.25};
    CHECK(falls([&](double h) { return error<VerletDriven>(driven, at_time, h); }) ==
          Approx(3).margin(0.2));
    CHECK(falls([&](double h) { return error<YoshidaDriven>(driven, at_time, h); }) ==
          Approx(5).margin(0.2));
    CHECK(falls([&](double h) {
              return error<GaussShaken>(shaken, {{{1.0}, {0.5}}, 0.25}, h);
          }) == Approx(5).margin(0.2));
    CHECK(falls([&](double h) {
              return error<CurveShaken>(shaken, {{{0.5}, {0.75}}, 1.0}, h);
          }) == Approx(5).margin(0.2));
    CHECK(falls([&](double h) {
              return error<LagrangianRooted>(rooted, {{{0.5}, {0.75}}, 1.0}, h);
          }) == Approx(5).margin(0.2));
}

TEST_CASE("H_d^+ of a composed step is the action of its steps") {
    check_composed<YoshidaDriven, VerletDriven>();
    check_composed<ComposedCurveRooted, CurveRooted>();
    check_composed<ComposedRooted, LagrangianRooted>();
}

TEST_CASE("the action is the sum of (3.11) along a run") {
    check_run<VerletPendulum>(VerletPendulum::initial(), 0.1);
    check_run<GaussPendulum>(GaussPendulum::initial(), 0.1);
    check_run<LobattoKepler>(LobattoKepler::initial(), 0.05);
    check_run<YoshidaKepler>(YoshidaKepler::initial(), 0.05);
    check_run<YoshidaDriven>({{{0.75}, {-0.5}}, 0.25}, 0.1);
    check_run<Curve23Kepler>(Curve23Kepler::initial(), 0.05);
    check_run<ComposedCurveRooted>({{{0.75}, {-0.5}}, 0.25}, 0.1);
    check_run<ComposedLagrangian>(ComposedLagrangian::initial(), 0.02);
    check_run<LagrangianRooted>({{{0.75}, {-0.5}}, 0.25}, 0.1);
}

TEST_CASE("what the action begins anew with, and what it outlives") {
    check_promises<VerletPendulum>({{0.75}, {0.5}}, 0.1);
    check_promises<GaussPendulum>({{0.75}, {0.5}}, 0.1);
    check_promises<LobattoKepler>(LobattoKepler::initial(), 0.05);
    check_promises<VerletDriven>({{{0.75}, {0.5}}, 0.25}, 0.1);
    check_promises<GaussShaken>({{{0.75}, {0.5}}, 0.25}, 0.1);
    check_promises<Curve23Kepler>(Curve23Kepler::initial(), 0.05);
    check_promises<ComposedCurveRooted>({{{0.75}, {0.5}}, 0.25}, 0.1);
    check_promises<ComposedLagrangian>(ComposedLagrangian::initial(), 0.02);
    check_promises<LagrangianRooted>({{{0.75}, {0.5}}, 0.25}, 0.1);
}

TEST_CASE("a composition of which a later step fails leaves the action as it was") {
    check_later_failure<ComposedCurveRooted, CurveRooted>();
    check_later_failure<ComposedRooted, LagrangianRooted>();
}

TEST_CASE("the time is part of the state from which the action goes on") {
    VerletDriven stepper;
    VerletDriven::State x{{{0.75}, {-0.5}}, 0.25};
    REQUIRE(stepper.step(x, 0.1).ok());
    const double H = stepper.generating_function();
    const double S = stepper.action();
    VerletDriven::State never = x;
    never.t = std::numeric_limits<double>::infinity();
    REQUIRE_FALSE(stepper.step(never, 0.1).ok());
    CHECK(stepper.generating_function() == H);
    CHECK(stepper.action() == S);
    const VerletDriven::State before = x;
    REQUIRE(stepper.step(x, 0.1).ok());
    CHECK(went_on(stepper, before, S));
    x.t += 1;
    REQUIRE(stepper.step(x, 0.1).ok());
    CHECK(stepper.action() == stepper.generating_function());
}

// A plain sum of so many steps is off by 6e-15 of itself.
TEST_CASE("a long sum keeps what rounding cuts off") {
    VerletPendulum stepper;
    VerletPendulum::State x = VerletPendulum::initial();
    long double sum = 0;
    for (int i = 0; i < 200'000; ++i) {
        REQUIRE(stepper.step(x, 0.1).ok());
        sum += static_cast<long double>(dot(x.p, x.q) - stepper.generating_function());
    }
    const auto expected = static_cast<double>(static_cast<long double>(dot(x.p, x.q)) - sum);
    CHECK(std::abs(stepper.action() / expected - 1) < 4e-16);
}

TEST_CASE("float and long double have an action too") {
    BasicGaussPendulum<float> single;
    BasicGaussPendulum<long double> extended;
    BasicGaussPendulum<float>::State x{{0.75F}, {0.5F}};
    BasicGaussPendulum<long double>::State y{{0.75L}, {0.5L}};
    const OneStep<GaussPendulum> step({{0.75}, {0.5}}, 0.125);
    REQUIRE(single.step(x, 0.125F).ok());
    REQUIRE(extended.step(y, 0.125L).ok());
    CHECK(std::abs(static_cast<double>(single.generating_function()) - step.H) < 1e-6);
    CHECK(std::abs(static_cast<double>(extended.generating_function()) - step.H) < 1e-15);
}

TEST_CASE("one header has the curve of a step and its action") {
    GaussPendulum stepper;
    GaussPendulum::State x{{0.75}, {0.5}};
    REQUIRE(stepper.step(x, 0.125).ok());
    CHECK(stepper.position(1.0) == x.q);
    CHECK(std::abs(stepper.position(0.0)[0] - 0.75) < 1e-15);
}
