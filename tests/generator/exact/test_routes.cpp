// The two routes of Algorithm 4.3, and the identities that every tableau satisfies.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <tuple>

#include <catch2/catch.hpp>

#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

bool equal(const NumberVector& left, const NumberVector& right) {
    if (left.size() != right.size()) return false;
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (!(left[i] - right[i]).is_zero()) return false;
    }
    return true;
}

/// b_i a~_ij + b_j a_ji - b_i b_j is zero for all i, j.
bool symplecticity_conditions_hold(const Tableau& tableau) {
    const auto& [b, A, A_tilde] = std::tie(tableau.b, tableau.A, tableau.A_tilde);
    for (std::size_t i = 0; i < b.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (!(b[i] * A_tilde[i][j] + b[j] * A[j][i] - b[i] * b[j]).is_zero()) return false;
        }
    }
    return true;
}

/// M M^-1 is the identity.
bool is_inverse(const NumberMatrix& M, const NumberMatrix& inverse) {
    for (std::size_t i = 0; i < M.size(); ++i) {
        for (std::size_t j = 0; j < M.size(); ++j) {
            Number entry;
            for (std::size_t k = 0; k < M.size(); ++k) entry = entry + M[i][k] * inverse[k][j];
            if (!(entry - Number(i == j ? 1 : 0)).is_zero()) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("both routes agree, and the tableau is symplectic and consistent") {
    const auto given =
        GENERATE(as<std::string>(),
                 // the paper's
                 "symplectic-euler", "midpoint", "adjoint-symplectic-euler", "stormer-verlet",
                 "1, tau | 0, 1", "trig3", "chebyshev:1", "chebyshev:2", "chebyshev:3",
                 // other families with exact nodes
                 "chebyshev:4", "gauss:2", "gauss:3", "gauss:4", "gauss:5", "lobatto:3",
                 "lobatto:4", "lobatto:5", "radau-left:3", "radau-right:3", "newton-cotes:5",
                 "newton-cotes-open:4", "clenshaw-curtis:4", "clenshaw-curtis:5", "fejer:3",
                 "fejer:4", "fejer:7", "trig:5 | 0, 1/4, 1/2, 3/4, 1",
                 // other bases
                 "1, cos(pi*tau) | gauss:2", "trig:3 | gauss:3", "trig:3 | 1/7, 1/2, 6/7",
                 "1, cos(2*pi*tau), sin(2*pi*tau) | 0, 1/3, 2/3", "1, exp(tau) | gauss:2",
                 "1, exp(tau), exp(-tau) | 0, 1/2, 1", "1, tau, exp(-3*tau) | 0, 1/3, 1",
                 "1, tau*cos(tau) | 1/4, 1", "1, exp(tau)*sin(pi*tau) | 1/4, 3/4",
                 "1, cosh(tau), tau^2 | 0, 1/2, 1", "exp(tau), exp(tau)+1 | 0, 1",
                 "1, tau, cos(w*tau), sin(w*tau) | 0, 1/3, 2/3, 1", "1, exp(w*tau) | 0, 1");
    CAPTURE(given);
    const Tableau tableau = derive(any_method(given));
    const std::size_t s = tableau.stages();

    const Routes routes = both_routes(any_method(given));
    CHECK(equal(routes.by_matrix.b, routes.by_integration.b));
    REQUIRE(routes.by_integration.A.size() == s);
    for (std::size_t i = 0; i < s; ++i)
        CHECK(equal(routes.by_matrix.A[i], routes.by_integration.A[i]));
    CHECK(texts(routes.by_matrix.b) == texts(tableau.b));

    CHECK(is_inverse(tableau.galerkin->M, tableau.galerkin->M_inverse));
    CHECK(symplecticity_conditions_hold(tableau));
    CHECK(sum(tableau.b).is_one());
    for (std::size_t i = 0; i < s; ++i) {
        CHECK((sum(tableau.A[i]) - tableau.c[i]).is_zero());
        CHECK((sum(tableau.A_tilde[i]) - tableau.c_tilde[i]).is_zero());
    }
}

TEST_CASE("the identities would show a wrong tableau") {
    Tableau tableau = derive(method("trig3"));
    REQUIRE(symplecticity_conditions_hold(tableau));
    tableau.A[1][2] = tableau.A[1][2] + Number(1) / Number(1000000);
    CHECK_FALSE(symplecticity_conditions_hold(tableau));
    CHECK_FALSE((sum(tableau.A[1]) - tableau.c[1]).is_zero());
    // The printed Example 4.5 has A~ = A (the trapezoidal rule).
    Tableau printed = derive(method("stormer-verlet"));
    printed.A_tilde = printed.A;
    CHECK_FALSE(symplecticity_conditions_hold(printed));
}
