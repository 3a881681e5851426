// What the general Galerkin form can do.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/certify/rule_certificate.hpp"
#include "tests/exact/exact.hpp"

using namespace hvi::gen;

namespace {

RuleCertificate certificate(const std::string& basis, const std::string& nodes, int max_order) {
    return std::get<RuleCertificate>(certify(method(basis, nodes), max_order));
}

}  // namespace

TEST_CASE("a fourth node of Gauss keeps order 6, and takes the intervals of stability away") {
    // By an independent computation: the first interval ends at 3.142467, the next one begins at
    // sqrt(10).
    const RuleCertificate found = certificate("1, tau, tau^2", "gauss:4", 7);
    CHECK(found.nystrom.order == 6);
    CHECK_FALSE(found.nystrom.is_at_least);
    REQUIRE(found.stability);
    REQUIRE(found.stability->stable.size() >= 2);
    CHECK(found.stability->stable[0].high.nearest_double() == Approx(3.142467).margin(5e-7));
    CHECK(found.stability->stable[1].low.nearest_double() == Approx(std::sqrt(10.0)));
    CHECK(found.oscillator->determinant_one.holds);
    CHECK(found.is_proved());
}

TEST_CASE("orders, symmetry and what is explicit") {
    const RuleCertificate verlet = certificate("1", "0, 1", 4);
    CHECK(verlet.nystrom.order == 2);
    CHECK(verlet.symmetric.holds);
    CHECK(verlet.symplectic.holds);
    CHECK(verlet.is_explicit);
    CHECK(verlet.stability->stable[0].high.nearest_double() == Approx(2.0));

    const RuleCertificate simpson = certificate("1, tau", "0, 1/2, 1", 5);
    CHECK(simpson.nystrom.order == 4);
    CHECK(simpson.symmetric.holds);
    CHECK_FALSE(simpson.is_explicit);

    // Nodes that are not symmetric: the rule is exact for degree 2.
    const RuleCertificate skew = certificate("1, tau", "1/3, 1/2, 1", 5);
    CHECK_FALSE(skew.symmetric.holds);
    CHECK(skew.symmetric.proved);
    CHECK(skew.symplectic.holds);
    // Weights 27/160 and so on have none below zero; of 1/4, 1/2, 3/4 the middle one is -1/3.
    CHECK(certificate("1, tau", "1/4, 1/2, 3/4", 4).negative_weights ==
          std::vector<std::size_t>{2});
    CHECK(certificate("1", "-1/2, 3/2", 2).nodes_outside == std::vector<std::size_t>{1, 2});
}

TEST_CASE("a rule whose table is not that of (4.6) is found out") {
    GalerkinRule rule = std::get<GalerkinRule>(derive_any(method("1, tau", "0, 1/2, 1")));
    CHECK(certify(rule, 4).symplectic.holds);
    rule.n[1][0] = rule.n[1][0] + Number(1);
    CHECK_FALSE(certify(rule, 4).symplectic.holds);
}
