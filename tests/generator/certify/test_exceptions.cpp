// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/certify/exceptions.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

/// `w=2/3: order 3` for each.
std::vector<std::string> found(const std::string& basis, const std::string& nodes,
                               int max_order = 8) {
    const Method given = method(basis, nodes);
    const OrderConditions generic = orders(derive(given), max_order).general;
    std::vector<std::string> result;
    for (const ExceptionalValue& value : exceptions(given, generic, max_order)) {
        result.push_back(value.parameter + "=" + text(value.value) + ": order " +
                         (value.is_at_least ? "at least " : "") + std::to_string(value.order));
    }
    return result;
}

using Lines = std::vector<std::string>;

}  // namespace

// The order expected of polynomials at these nodes is min(p, 2(p - s) + 2) with the order p of the
// interpolatory rule, as reference.json confirms for other nodes.
TEST_CASE("values of a parameter that raise the order are found") {
    CHECK(orders(derive(method("1, tau", "0, w")), 8).general.order == 2);
    CHECK(found("1, tau", "0, w") == Lines{"w=2/3: order 3"});  // Radau
    CHECK(found("1", "w") == Lines{"w=1/2: order 2"});          // the midpoint rule
    // Gauss' nodes of order 4; w = 1/2 would make them equal.
    CHECK(found("1, tau", "1/2-w, 1/2+w") ==
          Lines{"w=-sqrt(3)/6: order 4", "w=sqrt(3)/6: order 4"});
    // Simpson's rule.
    CHECK(found("1, tau, tau^2", "0, w, 1") == Lines{"w=1/2: order 4"});
}

TEST_CASE("where there is no better value, none is listed") {
    CHECK(found("1, cos(w*tau)", "0, 1").empty());
    CHECK(found("1, tau", "w, 1+w^2").empty());  // w^2 ... has no real zero in common
    CHECK(found("1, tau", "u, w").empty());      // two parameters
    CHECK(found("1, tau", "0, w", 1).empty());   // nothing was seen to fail
}
