// Stability of maps whose determinant is not 1: where they contract.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/stability.hpp"

using namespace hvi::gen;

TEST_CASE("a map with another determinant is stable where it contracts") {
    const auto stable = [](const PartitionedMethod& method) {
        return ends(linear_stability(oscillator_map(method), 20));
    };
    // The interval of the classical method on the imaginary axis.
    CHECK(stable(kutta_4()) == "(0, 2*sqrt(2))");
    // Euler's method grows, and so does Heun's: |R|^2 = 1 + z^4/4.
    CHECK(stable(runge_kutta({{"0"}}, {"1"})).empty());
    CHECK(stable(runge_kutta({{"0", "0"}, {"1", "0"}}, {"1/2", "1/2"})).empty());
    // Kutta's third-order rule: |R|^2 = 1 - z^4/12 + z^6/36 up to sqrt(3).
    CHECK(stable(runge_kutta({{"0", "0", "0"}, {"1/2", "0", "0"}, {"-1", "2", "0"}},
                             {"1/6", "2/3", "1/6"})) == "(0, sqrt(3))");
    // The implicit Euler rule damps everything; |R|^2 = 1/(1 + z^2).
    const LinearStability implicit =
        linear_stability(oscillator_map(runge_kutta({{"1"}}, {"1"})), 20);
    CHECK(ends(implicit) == "(0, 20)");
    CHECK(implicit.at_infinity.is_stable);
    CHECK(implicit.proved);
    CHECK(implicit.poles.empty());
    CHECK_FALSE(linear_stability(oscillator_map(kutta_4()), 20).at_infinity.is_stable);
}

TEST_CASE("poles and points on the circle split intervals of contraction") {
    // a_11 a~_11 = -1: the stage is singular at z = 1. With b = 1, A = -1 and A~ = 1:
    // D = 1 - z^2, m11 = 1 - 2 z^2, m22 = 1, det = (m11 m22 + z^2)/D^2 = 1/(1 - z^2).
    PartitionedMethod method = runge_kutta({{"-1"}}, {"1"});
    method.A_tilde = matrix({{"1"}});
    const LinearStability stability = linear_stability(oscillator_map(method), 20);
    REQUIRE(stability.poles.size() == 1);
    CHECK(text(stability.poles.front()) == "1");
    for (const StabilityInterval& interval : stability.stable) {
        CHECK((interval.high.nearest_double() <= 1 || interval.low.nearest_double() >= 1));
    }
}

TEST_CASE("a determinant that is 1 only within enclosures is taken for 1") {
    Tableau tableau = derive(method("lobatto:8"));
    const OscillatorMap map = oscillator_map(partitioned_method(tableau));
    CHECK(map.determinant_one.holds);
    CHECK_FALSE(map.determinant_one.proved);
    CHECK(ends(linear_stability(map, 3)) == "(0, 3)");
}
