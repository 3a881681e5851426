// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/methods/properties.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

PartitionedMethod coefficients(const std::string& method) {
    return partitioned_method(tableau(method));
}

bool is(const Verdict& verdict, bool holds, bool proved = true) {
    return verdict.holds == holds && verdict.proved == proved;
}

}  // namespace

TEST_CASE("the methods of Algorithm 4.3 are symplectic") {
    const auto methods = {"gauss:1",     "gauss:4",         "lobatto:3",         "radau-left:3",
                          "chebyshev:3", "newton-cotes:5",  "clenshaw-curtis:4", "symplectic-euler",
                          "trig3",       "1, tau | 0, 2/3", "1, exp(tau) | 0, 1"};
    for (const char* const method : methods) {
        CAPTURE(method);
        CHECK(is(is_symplectic(tableau(method)), true));
        CHECK(is(is_symplectic(coefficients(method)), true));
    }
    CHECK(is(is_symplectic(tableau("gauss:12")), true));
    CHECK(is(is_symplectic(tableau("chebyshev:9")), true));
    CHECK(is(is_symplectic(tableau("1, exp(tau^2) | 0, 1")), true, false));
}

TEST_CASE("what is not symplectic is found out") {
    PartitionedMethod method = coefficients("lobatto:3");
    method.A_tilde = method.A;  // Lobatto IIIA alone
    CHECK(is(is_symplectic(method), false));
    method = coefficients("gauss:2");
    method.b_tilde = {Number(1), Number(0)};
    CHECK(is(is_symplectic(method), false));
    method = {{1}, {2}, {{Number(1) / Number(2)}}, {{1}}};  // but for b~ = b
    CHECK(is(is_symplectic(method), false));
    method = coefficients("gauss:3");
    method.A[1][2] = method.A[1][2] + Number(1) / Number(1000000000000);
    CHECK(is(is_symplectic(method), false));
}

TEST_CASE("methods on symmetric nodes and spans are symmetric") {
    for (const char* const method :
         {"gauss:1", "gauss:4", "lobatto:3", "chebyshev:3", "newton-cotes:5", "trig3",
          "1, tau, tau^2 | 1, 0, 1/2", "1, cos(pi*tau) | 0, 1"}) {
        CAPTURE(method);
        CHECK(is(is_symmetric(tableau(method)), true));
        CHECK(is(is_symmetric(coefficients(method)), true));
    }
    for (const char* const method : {"symplectic-euler", "radau-left:3", "1, tau | 0, 2/3",
                                     "1, exp(tau) | 0, 1", "1, tau, tau^2 | 0, 1/4, 1"}) {
        CAPTURE(method);
        CHECK(is(is_symmetric(tableau(method)), false));
        CHECK(is(is_symmetric(coefficients(method)), false));
    }
    CHECK(is(is_symmetric(tableau("gauss:12")), true));
    CHECK(is(is_symmetric(coefficients("gauss:6")), true, false));
}

TEST_CASE("equal nodes do not hide the symmetry") {
    // Two half steps of the midpoint rule, and the second before the first; c = 1/4, 3/4.
    const Number half = Number(1) / Number(2);
    const Number quarter = Number(1) / Number(4);
    PartitionedMethod method{{half, half}, {half, half}, {{quarter, 0}, {half, quarter}}, {}};
    method.A_tilde = method.A;
    CHECK(is(is_symmetric(method), true));
    std::swap(method.A[0], method.A[1]);
    std::swap(method.A[0][0], method.A[0][1]);
    std::swap(method.A[1][0], method.A[1][1]);
    method.A_tilde = method.A;
    CHECK(is(is_symmetric(method), true));
    // Stages of the midpoint rule and of nothing, all at 1/2, in two orders.
    method = {{1, 0, 0}, {1, 0, 0}, {{half, 0, 0}, {half, 1, -1}, {half, 2, -2}}, {}};
    method.A_tilde = method.A;
    CHECK(is(is_symmetric(method), false));
    method.A[2] = {half, 1, -1};
    method.A_tilde = method.A;
    CHECK(is(is_symmetric(method), true));
}

TEST_CASE("Runge-Kutta methods are those with A~ = A") {
    for (const char* const method : {"gauss:1", "gauss:4", "gauss:2"}) {
        CHECK(is(is_runge_kutta(tableau(method)), true));
        CHECK(is(is_runge_kutta(coefficients(method)), true));
    }
    CHECK(is(is_runge_kutta(tableau("gauss:20")), true));
    for (const char* const method : {"lobatto:2", "chebyshev:3", "symplectic-euler", "trig3"}) {
        CHECK(is(is_runge_kutta(tableau(method)), false));
        CHECK(is(is_runge_kutta(coefficients(method)), false));
    }
}

TEST_CASE("the first condition of symplecticity that fails is told") {
    CHECK_FALSE(symplectic_defect(coefficients("lobatto:3")));
    // Example 4.5 as it is printed: A~ = A, with the residuals diag(-1/4, 1/4).
    PartitionedMethod method = coefficients("stormer-verlet");
    method.A_tilde = method.A;
    auto defect = symplectic_defect(method);
    REQUIRE(defect);
    CHECK(defect->i == 0);
    CHECK(defect->j == 0);
    CHECK(text(defect->residual) == "-1/4");
    method.b_tilde = {number("1/2"), number("1/3")};
    defect = symplectic_defect(method);
    REQUIRE(defect);
    CHECK(defect->i == 1);
    CHECK_FALSE(defect->j);
    CHECK(text(defect->residual) == "-1/6");
}

TEST_CASE("weights are common or not") {
    PartitionedMethod method = coefficients("gauss:2");
    CHECK(is(has_common_weights(method), true));
    CHECK(is(has_common_weights(tableau("gauss:8")), true));
    method.b_tilde = {Number(1), Number(0)};
    CHECK(is(has_common_weights(method), false));
}
