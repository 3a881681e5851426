// Proposition 4.1: where L is hyperregular, the steps of (4.14) are those of (4.6).
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <catch2/catch.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <lagrangian/double_pendulum.hpp>
#include <lagrangian/double_pendulum_h.hpp>
#include <lagrangian/double_pendulum_newton.hpp>
#include <lagrangian/double_pendulum_rule.hpp>
#include <lagrangian/double_pendulum_rule_h.hpp>
#include <lagrangian/driven.hpp>
#include <lagrangian/driven_h.hpp>
#include <lagrangian/driven_rule.hpp>
#include <lagrangian/driven_rule_h.hpp>
#include <lagrangian/driven_trig.hpp>
#include <lagrangian/driven_trig_h.hpp>
#include <lagrangian/pendulum.hpp>
#include <lagrangian/pendulum_h.hpp>
#include <lagrangian/pendulum_rule.hpp>
#include <lagrangian/pendulum_rule_h.hpp>

using namespace hvi::generated;
using hvi::math::Widest;

namespace {

/// Returns the largest distance of both in `steps` steps from equal starts, as a multiple of
/// epsilon.
template <class OfLagrangian, class OfHamiltonian>
double distance(double h, int steps) {
    using Scalar = typename OfLagrangian::Scalar;
    OfLagrangian left;
    OfHamiltonian right;
    auto x = OfLagrangian::initial();
    typename OfHamiltonian::State y;
    y.q = x.q;
    y.p = x.p;
    Scalar largest = 0;
    for (int i = 0; i < steps; ++i) {
        REQUIRE(left.step(x, Scalar(h)).ok());
        REQUIRE(right.step(y, Scalar(h)).ok());
        for (std::size_t k = 0; k < x.q.size(); ++k) {
            for (const Scalar difference : {x.q[k] - y.q[k], x.p[k] - y.p[k]}) {
                const Scalar size = hvi::detail::abs(difference);
                largest = size > largest ? size : largest;
            }
        }
    }
    return static_cast<double>(largest / hvi::detail::epsilon<Scalar>);
}

/// Returns the largest distance between the curves of both, over some steps, each from equal
/// states.
template <class OfLagrangian, class OfHamiltonian>
double distance_of_curves(double h) {
    OfLagrangian left;
    OfHamiltonian right;
    auto x = OfLagrangian::initial();
    double largest = 0;
    for (int i = 0; i < 20; ++i) {
        typename OfHamiltonian::State y;
        y.q = x.q;
        y.p = x.p;
        if constexpr (std::is_same_v<decltype(x), hvi::TimedState<typename OfLagrangian::Vector>>) {
            y.t = x.t;
        }
        REQUIRE(left.step(x, h).ok());
        REQUIRE(right.step(y, h).ok());
        for (const double tau : {0.0, 0.2, 0.5, 0.875, 1.0}) {
            const auto a = left.position(tau), b = right.position(tau);
            for (std::size_t k = 0; k < a.size(); ++k) {
                largest = std::fmax(largest, std::abs(a[k] - b[k]));
            }
            const auto c = left.momentum(tau), d = right.momentum(tau);
            for (std::size_t k = 0; k < c.size(); ++k) {
                largest = std::fmax(largest, std::abs(c[k] - d[k]));
            }
        }
        for (std::size_t k = 0; k < x.q.size(); ++k) { CHECK(left.position(1)[k] == x.q[k]); }
    }
    return largest;
}

template <template <class...> class OfLagrangian, template <class...> class OfHamiltonian>
void check(double h, double most) {
    constexpr int steps = 1000;
    const double in_double = distance<OfLagrangian<double>, OfHamiltonian<double>>(h, steps);
    const double in_widest = distance<OfLagrangian<Widest>, OfHamiltonian<Widest>>(h, steps);
    CAPTURE(in_double, in_widest);
    CHECK(in_double < most);
    CHECK(in_widest < most);
    if (hvi::detail::bits<Widest> == 113) {
        CHECK(in_widest * static_cast<double>(hvi::detail::epsilon<Widest>) < 1e-30);
    }
}

}  // namespace

// NOTE: both round on their own, and what each step leaves grows along the motion.

TEST_CASE("as many functions as nodes, on a separable system") {
    check<BasicLagrangianPendulum, BasicHamiltonianPendulum>(1.0 / 16, 2000);
}

TEST_CASE("more nodes than functions, on a separable system") {
    check<BasicLagrangianPendulumRule, BasicHamiltonianPendulumRule>(1.0 / 16, 2000);
}

TEST_CASE("as many functions as nodes, on systems that are not separable") {
    check<BasicLagrangianDoublePendulum, BasicHamiltonianDoublePendulum>(1.0 / 128, 2000);
    check<BasicLagrangianDoublePendulumNewton, BasicHamiltonianDoublePendulum>(1.0 / 128, 2000);
}

TEST_CASE("more nodes than functions, on systems that are not separable") {
    check<BasicLagrangianDoublePendulumRule, BasicHamiltonianDoublePendulumRule>(1.0 / 128, 2000);
}

TEST_CASE("the same where L depends on time and has terms that are linear in v") {
    check<BasicLagrangianDriven, BasicHamiltonianDriven>(1.0 / 32, 2000);
    check<BasicLagrangianDrivenRule, BasicHamiltonianDrivenRule>(1.0 / 32, 2000);
    check<BasicLagrangianDrivenTrig, BasicHamiltonianDrivenTrig>(1.0 / 32, 2000);
}

// NOTE: of H some have the momenta eliminated, some the slopes of pairs, some both unknowns.
TEST_CASE("the curves between the ends of steps are the same") {
    CHECK(distance_of_curves<LagrangianDoublePendulum, HamiltonianDoublePendulum>(0.05) < 1e-14);
    CHECK(distance_of_curves<LagrangianPendulumRule, HamiltonianPendulumRule>(0.125) < 1e-14);
    CHECK(distance_of_curves<LagrangianDrivenRule, HamiltonianDrivenRule>(0.0625) < 1e-14);
    CHECK(distance_of_curves<LagrangianDrivenTrig, HamiltonianDrivenTrig>(0.0625) < 1e-14);
}
