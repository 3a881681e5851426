// Steps of counted sweeps, against plain loops and against steps to round-off.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/ensemble.hpp>
#include <hvi/fixed_sweeps.hpp>
#include <sweeps/bead_1.hpp>
#include <sweeps/bead_3.hpp>
#include <sweeps/composed_2.hpp>
#include <sweeps/composed_40.hpp>
#include <sweeps/composed_round_off.hpp>
#include <sweeps/gauss_4_separable.hpp>
#include <sweeps/joint_1.hpp>
#include <sweeps/joint_3.hpp>
#include <sweeps/joint_3_lanes.hpp>
#include <sweeps/joint_6_2.hpp>
#include <sweeps/joints_2.hpp>
#include <sweeps/kepler_50.hpp>
#include <sweeps/kepler_round_off.hpp>
#include <sweeps/pendulum_1.hpp>
#include <sweeps/pendulum_2.hpp>
#include <sweeps/pendulum_2_lanes.hpp>
#include <sweeps/pendulum_3.hpp>
#include <sweeps/pendulum_6_2.hpp>
#include <sweeps/pendulums_2.hpp>

#include "model.hpp"

using namespace hvi::generated;
using sweeps_test::Model;
using sweeps_test::Order;
using sweeps_test::Real;

namespace {

constexpr int more_from_start = 16;

/// Compares ten steps with those of the model, and counts iterations.
template <class Stepper, class Modelled>
void check_model(Modelled model, double h, int sweeps) {
    Stepper stepper;
    typename Stepper::State x{};
    x.q[0] = static_cast<double>(model.q);
    x.p[0] = static_cast<double>(model.p);
    for (int step = 0; step < 10; ++step) {
        const hvi::Status status = stepper.step(x, h);
        REQUIRE(status.ok());
        CHECK(status.iterations == (step < 2 ? sweeps + more_from_start : sweeps));
        model.step(static_cast<Real>(h), sweeps);
        CAPTURE(sweeps, step);
        CHECK(std::abs(x.q[0] - static_cast<double>(model.q)) < 4e-15);
        CHECK(std::abs(x.p[0] - static_cast<double>(model.p)) < 4e-15);
    }
}

template <class Stepper>
void check_pendulum(int sweeps) {
    const auto force = [](Real q, Real, Real) { return -std::sin(q); };
    const auto velocity = [](Real, Real p, Real) { return p; };
    check_model<Stepper>(Model(force, velocity, Order::positions, 1.5L, 0.25L), 0.3, sweeps);
}

/// H = (q^2 + 1)(p^2 + 1)/2.
template <class Stepper>
void check_joint(int sweeps) {
    const auto force = [](Real q, Real p, Real) { return -q * (p * p + 1); };
    const auto velocity = [](Real q, Real p, Real) { return p * (q * q + 1); };
    check_model<Stepper>(Model(force, velocity, Order::jointly, -0.5L, 0.25L), 0.2, sweeps);
}

/// H = p^2 (2 + sin q)/4 + cos(t) q.
template <class Stepper>
void check_bead(int sweeps) {
    const auto force = [](Real q, Real p, Real t) {
        return -p * p * std::cos(q) / 4 - std::cos(t);
    };
    const auto velocity = [](Real q, Real p, Real) { return p * (2 + std::sin(q)) / 2; };
    check_model<Stepper>(Model(force, velocity, Order::in_turn, 0.5L, 1.0L), 0.2, sweeps);
}

/// The distance of two states over the norm of one.
template <class A, class B>
double distance(const A& x, const B& y) {
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        difference += std::abs(x.q[k] - y.q[k]) + std::abs(x.p[k] - y.p[k]);
        size += std::abs(x.q[k]) + std::abs(x.p[k]);
    }
    return difference / size;
}

template <class One, class Other>
double distance_after(int steps, double h) {
    One one;
    Other other;
    auto x = One::initial();
    auto y = Other::initial();
    for (int step = 0; step < steps; ++step) {
        REQUIRE(one.step(x, h).ok());
        REQUIRE(other.step(y, h).ok());
    }
    return distance(x, y);
}

/// H = p^2/2 - cos q.
struct Pendulum {
    using Vector = std::array<double, 1>;
    void dHdq(const Vector& q, Vector& out) const { out[0] = std::sin(q[0]); }
    void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
};

template <class Solver>
hvi::State<Pendulum::Vector> pendulum_after(int steps, double h) {
    Gauss4Separable<Pendulum, Solver> stepper;
    hvi::State<Pendulum::Vector> x{{1.5}, {0.25}};
    for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(x, h).ok()); }
    return x;
}

/// The distance of steps of counted sweeps from those to round-off.
template <int count>
double distance_of(int steps, double h) {
    return distance(pendulum_after<hvi::FixedSweeps<count>>(steps, h),
                    pendulum_after<hvi::FixedPoint>(steps, h));
}

}  // namespace

TEST_CASE("counted sweeps are those of plain loops over the tableau") {
    check_pendulum<Pendulum1>(1);
    check_pendulum<Pendulum2>(2);
    check_pendulum<Pendulum3>(3);
    check_joint<Joint1>(1);
    check_joint<Joint3>(3);
    check_bead<Bead1>(1);
    check_bead<Bead3>(3);
}

TEST_CASE("counted sweeps of stages in lanes are, too") {
    check_pendulum<Pendulum2Lanes>(2);
    check_joint<Joint3Lanes>(3);
}

TEST_CASE("a change of h, or of the state, begins anew") {
    Pendulum2 stepper;
    auto x = Pendulum2::initial();
    const auto sweeps = [&](double h) { return stepper.step(x, h).iterations; };
    const int more = 2 + more_from_start;
    CHECK(std::vector{sweeps(0.1), sweeps(0.1), sweeps(0.1)} == std::vector{more, more, 2});
    CHECK(std::vector{sweeps(0.2), sweeps(0.2), sweeps(0.2)} == std::vector{more, more, 2});
    x.q[0] += 0.1;
    CHECK(std::vector{sweeps(0.2), sweeps(0.2), sweeps(0.2)} == std::vector{more, more, 2});
    stepper.reset();
    CHECK(std::vector{sweeps(0.2), sweeps(0.2), sweeps(0.2)} == std::vector{more, more, 2});
}

TEST_CASE("many sweeps are those to round-off") {
    CHECK(distance_after<Kepler50, KeplerRoundOff>(400, 0.05) < 1e-12);
    CHECK(distance_after<Composed40, ComposedRoundOff>(100, 0.1) < 1e-13);
    CHECK(distance_of<40>(100, 0.2) < 1e-13);
}

TEST_CASE("each sweep brings steps nearer to those to round-off") {
    const std::array<double, 5> distances{distance_of<1>(40, 0.25), distance_of<2>(40, 0.25),
                                          distance_of<3>(40, 0.25), distance_of<4>(40, 0.25),
                                          distance_of<5>(40, 0.25)};
    // A sweep contracts by (h omega)^2/16 or less: Gauss' stages are no larger than their step.
    for (std::size_t k = 1; k < distances.size(); ++k) {
        CAPTURE(k);
        CHECK(distances[k] < distances[k - 1] / 16);
    }
    CHECK(distances.front() > 1e-8);
    CHECK(distances.back() < 1e-12);
    // In a row the steps of a composition begin with slopes that are extrapolated, too.
    CHECK(distance_after<Composed2, ComposedRoundOff>(100, 0.1) < 1e-5);
}

TEST_CASE("the order is that of the method") {
    using Few = hvi::FixedSweeps<3>;
    const auto exact = pendulum_after<hvi::FixedPoint>(1024, 1.0 / 256);
    const double coarse = distance(pendulum_after<Few>(16, 0.25), exact),
                 fine = distance(pendulum_after<Few>(32, 0.125), exact);
    CHECK(coarse > 1e-10);
    CHECK(std::log2(coarse / fine) > 7.5);
}

TEMPLATE_TEST_CASE("trajectories side by side are those of single ones", "",
                   (std::pair<Pendulums2, Pendulum62>), (std::pair<Joints2, Joint62>)) {
    using Many = typename TestType::first_type;
    std::vector<typename Many::Trajectory> x;
    for (int k = 0; k < 20; ++k) { x.push_back({{-0.5 + 0.05 * k}, {0.25}}); }
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(0.2, 100, 1);
    for (std::size_t i = 0; i < x.size(); ++i) {
        typename TestType::second_type stepper;
        auto y = x[i];
        int iterations = 0;
        for (int step = 0; step < 100; ++step) {
            const hvi::Status status = stepper.step(y, 0.2);
            REQUIRE(status.ok());
            iterations = status.iterations;
        }
        CHECK(ensemble.status(i).iterations == iterations);
        CHECK(distance(ensemble.state(i), y) < 1e-13);
    }
}

namespace {

/// A force that vanishes far away, and is immense near 0.
struct Wall {
    using Vector = std::array<double, 1>;
    void dHdq(const Vector& q, Vector& out) const { out[0] = std::abs(q[0]) > 1 ? 0 : -1e308; }
    void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
};

}  // namespace

TEST_CASE("a step through infinity is none") {
    Gauss4Separable<Wall, hvi::FixedSweeps<2>> stepper;
    const hvi::State<Wall::Vector> start{{0.5}, {1.0}};
    auto x = start;
    CHECK(stepper.step(x, 1e3).code() == hvi::Status::Code::not_finite);
    CHECK(x.q == start.q);
    CHECK(x.p == start.p);
    // The step after it is one of a new stepper.
    x.q[0] = 2;
    const hvi::Status status = stepper.step(x, 0.5);
    CHECK(status.ok());
    CHECK(x.q[0] == Approx(2.5).epsilon(1e-15));
}
