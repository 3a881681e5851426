// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/certify/known.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

using Names = std::vector<std::string>;

/// b_j - a_ij for the stages in reverse, for A and for A~ (Hairer, Lubich & Wanner, Geometric
/// Numerical Integration, Theorem II.8.3).
bool are_adjoint(const Tableau& one, const Tableau& other) {
    const std::size_t s = one.stages();
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            const std::size_t k = s - 1 - i;
            const std::size_t l = s - 1 - j;
            if (!(one.b[l] - one.A[k][l] - other.A[i][j]).is_zero()) { return false; }
            if (!(one.b[l] - one.A_tilde[k][l] - other.A_tilde[i][j]).is_zero()) { return false; }
        }
    }
    return true;
}

bool are_adjoint(const std::string& one, const std::string& other) {
    return on_new_ground([&](const Ground& ground) {
        return are_adjoint(derive_on(ground, any_method(one)).tableau,
                           derive_on(ground, any_method(other)).tableau);
    });
}

}  // namespace

TEST_CASE("a method given by basis and nodes has a name where it is a known one") {
    CHECK(known_names(tableau("1, tau | 0, 1")) ==
          Names{"lobatto:2", "newton-cotes:2", "clenshaw-curtis:2"});
    CHECK(known_names(tableau("1+tau, 1-2*tau | 1/2-sqrt(3)/6, 1/2+sqrt(3)/6")) ==
          Names{"gauss:2", "chebyshev:2"});
    CHECK(known_names(tableau("tau^2, 1, tau | roots((2*tau-1)*(8*(tau-1/2)^2-1))")) ==
          Names{"chebyshev:3"});
    CHECK(known_names(tableau("1 | 0")) == Names{"symplectic-euler", "radau-left:1"});
    CHECK(known_names(tableau("gauss:8")) == Names{"gauss:8"});
    CHECK(known_names(tableau("1, tau | 0, 2/5")).empty());
    // Other functions at known nodes make another method.
    CHECK(known_names(tableau("1, exp(tau) | 0, 1")).empty());
}

TEST_CASE("the adjoint of a known method is known") {
    const auto check = [](const std::string& method, const std::string& adjoint) {
        CAPTURE(method, adjoint);
        const Names names = known_adjoints(tableau(method));
        CHECK(std::find(names.begin(), names.end(), adjoint) != names.end());
        CHECK(are_adjoint(method, adjoint));
    };
    check("symplectic-euler", "adjoint-symplectic-euler");
    check("adjoint-symplectic-euler", "symplectic-euler");
    check("radau-left:2", "radau-right:2");
    check("radau-left:3", "radau-right:3");
    check("1, tau | 0, 2/3", "radau-right:2");
    check("gauss:3", "gauss:3");
    CHECK(known_adjoints(tableau("1, tau | 0, 2/5")).empty());
    CHECK(known_adjoints(tableau("radau-left:7")) == Names{"radau-right:7"});
    CHECK_FALSE(are_adjoint("radau-left:2", "gauss:2"));
}
