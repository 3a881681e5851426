// Promises of steppers of Lagrangian scenes beside Proposition 4.1.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <driver/dual.hpp>
#include <driver/edge_symplectic.hpp>
#include <lagrangian/arm.hpp>
#include <lagrangian/chain.hpp>
#include <lagrangian/composed.hpp>
#include <lagrangian/double_pendulum.hpp>
#include <lagrangian/double_pendulum_h.hpp>
#include <lagrangian/double_pendulum_rule.hpp>
#include <lagrangian/driven.hpp>
#include <lagrangian/driven_h.hpp>
#include <lagrangian/spherical.hpp>
#include <lagrangian/spherical_fixed.hpp>

using namespace hvi::generated;
using Code = hvi::Status::Code;

namespace {

constexpr double pi = 3.14159265358979323846;

template <class State>
double distance(const State& x, const State& y) {
    double sum = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        sum += std::abs(x.q[k] - y.q[k]) + std::abs(x.p[k] - y.p[k]);
    }
    return sum;
}

template <class State>
bool same_bits(const State& x, const State& y) {
    return std::memcmp(&x.q, &y.q, sizeof x.q) == 0 && std::memcmp(&x.p, &y.p, sizeof x.p) == 0;
}

/// Where `count` steps lead until the time 1.
template <class Stepper>
typename Stepper::State end(int count) {
    Stepper stepper;
    auto x = Stepper::initial();
    for (int i = 0; i < count; ++i) { REQUIRE(stepper.step(x, 1.0 / count).ok()); }
    return x;
}

/// The order, by halving steps.
template <class Stepper>
double order(int count) {
    const auto exact = end<LagrangianDoublePendulum>(1024);
    return std::log2(distance(end<Stepper>(count), exact) /
                     distance(end<Stepper>(2 * count), exact));
}

/// L = v^T M v/2 with 1/(i + j + 1), times 27720 so that nothing is rounded, as M.
struct Hilbert {
    using Vector = std::array<double, 6>;

    static double entry(std::size_t i, std::size_t j) {
        return 27720.0 / static_cast<double>(i + j + 1);
    }
    void dLdv(const Vector&, const Vector& v, Vector& out) const {
        for (std::size_t i = 0; i < v.size(); ++i) {
            long double sum = 0;
            for (std::size_t j = 0; j < v.size(); ++j) {
                sum += static_cast<long double>(entry(i, j)) * static_cast<long double>(v[j]);
            }
            out[i] = static_cast<double>(sum);
        }
    }
    template <class Matrix>
    void d2Ldv2(const Vector&, const Vector& v, Matrix& out) const {
        for (std::size_t i = 0; i < v.size(); ++i) {
            for (std::size_t j = 0; j < v.size(); ++j) { out(i, j) = entry(i, j); }
        }
    }
};

}  // namespace

TEST_CASE("the state begins with p = dL/dv, and the velocity comes back") {
    const auto x = LagrangianSpherical::initial();
    CHECK(x.q[0] == Approx(pi / 3).epsilon(1e-15));
    CHECK(x.p[0] == 0);
    CHECK(x.p[1] == Approx(1.5).epsilon(1e-15));  // m l^2 sin(theta)^2 2
    const auto v = LagrangianSpherical().velocity(x);
    CHECK(v[0] == 0);
    CHECK(v[1] == Approx(2).epsilon(1e-15));
    CHECK(LagrangianSpherical().angular_momentum(x) == Approx(1.5).epsilon(1e-15));
    const auto y = LagrangianDriven::initial();
    CHECK(y.p[0] == Approx(17.0 / 8 - std::sin(1.0 / 3) / 2).epsilon(1e-15));
    CHECK(y.p[1] == Approx(1.25).epsilon(1e-15));
}

TEST_CASE("the momenta of a velocity are right to rounding, however nearly singular d2L/dv2 is") {
    // v of M v = p for Hilbert's matrix, whose condition number is 1.5e7, and p = M (1, ..., 1).
    const Hilbert system;
    Hilbert::Vector p{}, again{};
    system.dLdv({}, {1, 1, 1, 1, 1, 1}, p);
    system.dLdv({}, hvi::detail::velocity_of(system, Hilbert::Vector{}, p), again);
    for (std::size_t i = 0; i < p.size(); ++i) {
        CHECK(std::abs(again[i] - p[i]) <= 4 * std::numeric_limits<double>::epsilon() * p[i]);
    }
}

TEST_CASE("the energy v dL/dv - L is H") {
    auto x = LagrangianDriven::initial();
    LagrangianDriven of_lagrangian;
    HamiltonianDriven::State y;
    for (int i = 0; i < 20; ++i) {
        REQUIRE(of_lagrangian.step(x, 0.125).ok());
        y.q = x.q;
        y.p = x.p;
        y.t = x.t;
        CHECK(of_lagrangian.energy(x) == Approx(HamiltonianDriven().energy(y)).epsilon(1e-14));
    }
}

TEST_CASE("steps have the order of the method") {
    CHECK(order<LagrangianDoublePendulumRule>(32) == Approx(4).margin(0.1));
    CHECK(order<LagrangianDoublePendulum>(32) == Approx(6).margin(0.2));
    CHECK(order<LagrangianComposed>(64) == Approx(4).margin(0.1));
}

TEST_CASE("the derivative of steps is symplectic") {
    using D = hvi::driver::Dual<4>;
    const auto of_tableau = hvi::driver::SymplecticDefect<BasicLagrangianDoublePendulum<D>>().of(
        BasicLagrangianDoublePendulum<D>::initial(), 0.1, 20);
    REQUIRE(of_tableau);
    CHECK(*of_tableau < 1e-13);
    const auto of_rule = hvi::driver::SymplecticDefect<BasicLagrangianDoublePendulumRule<D>>().of(
        BasicLagrangianDoublePendulumRule<D>::initial(), 0.1, 20);
    REQUIRE(of_rule);
    CHECK(*of_rule < 1e-13);
}

TEST_CASE("a momentum whose coordinate does not occur stays, and the energy does not drift") {
    LagrangianSpherical stepper;
    auto x = LagrangianSpherical::initial();
    const double energy = stepper.energy(x);
    double first = 0, last = 0;
    for (int i = 0; i < 20000; ++i) {
        REQUIRE(stepper.step(x, 0.02).ok());
        double& largest = i < 10000 ? first : last;
        largest = std::fmax(largest, std::abs(stepper.energy(x) - energy));
    }
    CHECK(std::abs(x.p[1] - 1.5) < 1e-13);
    CHECK(last < 2 * first);
    CHECK(stepper.evaluations() > 20000);
    LagrangianArm arm;  // q1 does not occur in L
    auto y = LagrangianArm::initial();
    const double p1 = y.p[0];
    for (int i = 0; i < 1000; ++i) { REQUIRE(arm.step(y, 0.01).ok()); }
    CHECK(y.p[0] == Approx(p1).epsilon(1e-14));
}

TEST_CASE("-h leads back, and 0 leaves every bit") {
    LagrangianDoublePendulumRule stepper;
    const auto start = LagrangianDoublePendulumRule::initial();
    auto x = start;
    REQUIRE(stepper.step(x, 0.0).ok());
    CHECK(same_bits(x, start));
    for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, 0.05).ok()); }
    for (int i = 0; i < 10; ++i) { REQUIRE(stepper.step(x, -0.05).ok()); }
    CHECK(distance(x, start) < 1e-13);
}

TEST_CASE("a step that has no solution leaves the state and says why") {
    LagrangianSpherical stepper;
    auto pole = LagrangianSpherical::initial();
    pole.q[0] = 0;  // where d2L/dv2 is singular
    auto x = pole;
    CHECK(stepper.step(x, 0.01).code() == Code::singular);
    CHECK(same_bits(x, pole));
    CHECK(std::isnan(stepper.velocity(pole)[0]));
    auto none = LagrangianSpherical::initial();
    none.p[1] = std::numeric_limits<double>::quiet_NaN();
    x = none;
    CHECK(stepper.step(x, 0.01).code() == Code::not_finite);
    CHECK(same_bits(x, none));
    LagrangianSphericalFixed fixed;
    auto far = LagrangianSphericalFixed::initial();
    const auto start = far;
    CHECK_FALSE(fixed.step(far, 50.0).ok());
    CHECK(same_bits(far, start));
    CHECK(fixed.step(far, 0.01).ok());
}

TEST_CASE("stages come to rest with their velocities, not with their positions alone") {
    // NOTE: if iterations ended when the positions rest, the energy would fall by 8e-17 of itself
    // a step, to 1.6e-13.
    LagrangianSpherical stepper;
    auto x = LagrangianSpherical::initial();
    const double energy = stepper.energy(x);
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
        REQUIRE(stepper.step(x, 0.01).ok());
        largest = std::max(largest, std::abs(stepper.energy(x) - energy));
    }
    CHECK(largest < 2e-14 * std::abs(energy));
}

TEST_CASE("Newton's method steps a chain that is stiff") {
    LagrangianChain::Parameters parameters;
    parameters.g = 1e4;
    LagrangianChain stepper(parameters);
    auto x = LagrangianChain::initial(parameters);
    for (double& angle : x.q) { angle = 1e-3; }
    const double energy = stepper.energy(x);
    for (int i = 0; i < 200; ++i) { REQUIRE(stepper.step(x, 0.01).ok()); }
    CHECK(std::abs(stepper.energy(x) - energy) < 1e-6 * std::abs(energy));
}

TEST_CASE("vectors of Eigen take the same steps") {
    BasicLagrangianDoublePendulum<double, Eigen::Vector2d> of_eigen;
    auto y = BasicLagrangianDoublePendulum<double, Eigen::Vector2d>::initial();
    LagrangianDoublePendulum of_arrays;
    auto x = LagrangianDoublePendulum::initial();
    for (int i = 0; i < 50; ++i) {
        REQUIRE(of_eigen.step(y, 0.02).ok());
        REQUIRE(of_arrays.step(x, 0.02).ok());
        for (std::size_t k = 0; k < 2; ++k) {
            CHECK(x.q[k] == y.q[static_cast<Eigen::Index>(k)]);
            CHECK(x.p[k] == y.p[static_cast<Eigen::Index>(k)]);
        }
    }
    CHECK(of_eigen.velocity(y)[0] == of_arrays.velocity(x)[0]);
}
