// The families of nodes: how many, where, and in which order.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/methods/nodes.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

NumberVector nodes(const std::string& list) {
    return on_new_ground(
        [&](const Ground& ground) { return quadrature_nodes(parse_list(source(list)), ground).c; });
}

bool ascending_in_unit_interval(const NumberVector& c) {
    if (c.front().sign() < 0 || (Number(1) - c.back()).sign() < 0) return false;
    for (std::size_t i = 1; i < c.size(); ++i) {
        if ((c[i] - c[i - 1]).sign() <= 0) return false;
    }
    return true;
}

/// Whether c and the nodes d mirrored, 1 - d_s .. 1 - d_1, agree.
bool mirrored(const NumberVector& c, const NumberVector& d) {
    if (c.size() != d.size()) return false;
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (!is_tiny(c[i] - (Number(1) - d[c.size() - 1 - i]))) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("symmetric families") {
    const auto family = GENERATE(as<std::string>(), "gauss", "lobatto", "newton-cotes",
                                 "newton-cotes-open", "clenshaw-curtis", "fejer");
    for (int s = 2; s <= 13; ++s) {
        const std::string name = family + ":" + std::to_string(s);
        CAPTURE(name);
        const NumberVector c = nodes(name);
        CHECK(c.size() == static_cast<std::size_t>(s));
        CHECK(ascending_in_unit_interval(c));
        CHECK(mirrored(c, c));
    }
}

TEST_CASE("Chebyshev's nodes of equal weights") {
    for (const int s : {1, 2, 3, 4, 5, 6, 7, 9}) {
        const NumberVector c = nodes("chebyshev:" + std::to_string(s));
        CHECK(c.size() == static_cast<std::size_t>(s));
        CHECK(ascending_in_unit_interval(c));
        CHECK(mirrored(c, c));
    }
}

TEST_CASE("Radau's nodes on the left and on the right") {
    for (int s = 1; s <= 8; ++s) {
        const std::string size = std::to_string(s);
        const NumberVector both = nodes("radau-left:" + size + ", radau-right:" + size);
        const NumberVector left(both.begin(), both.begin() + s);
        const NumberVector right(both.begin() + s, both.end());
        CHECK(left.front().is_zero());
        CHECK(right.back().is_one());
        CHECK(ascending_in_unit_interval(left));
        CHECK(mirrored(left, right));
    }
}

TEST_CASE("nodes on a circle, projected") {
    CHECK(same(nodes("clenshaw-curtis:4"), {"0", "1/4", "3/4", "1"}));
    CHECK(same(nodes("fejer:4"), {"1/2-sqrt(2+sqrt(2))/4", "1/2-sqrt(2-sqrt(2))/4",
                                  "1/2+sqrt(2-sqrt(2))/4", "1/2+sqrt(2+sqrt(2))/4"}));
    // (1 - cos(3 pi/7))/2, (1 - cos(5 pi/14))/2, (1 - cos(7 pi/18))/2, (1 - cos(11 pi/22))/2
    CHECK(nodes("clenshaw-curtis:8")[3].decimal(20) == "0.38873953302184279786");
    CHECK(nodes("fejer:7")[2].decimal(20) == "0.28305813044122093976");
    CHECK(nodes("fejer:9")[3].decimal(20) == "0.32898992833716563348");
    CHECK(is_tiny(nodes("fejer:11")[5] - number("1/2")));
}

TEST_CASE("families, roots and numbers in one list") {
    CHECK(texts(nodes("0, gauss:1, 1")) == std::vector<std::string>{"0", "1/2", "1"});
    CHECK(texts(nodes("roots((tau-1/2)^2*(tau^2-2)), 0.1")) ==
          std::vector<std::string>{"-sqrt(2)", "1/2", "sqrt(2)", "1/10"});
    CHECK(nodes("newton-cotes:64").size() == 64);
    CHECK(nodes("gauss:64").size() == 64);
}

TEST_CASE("the polynomial of the nodes is known when it has rational coefficients") {
    const auto polynomial = [](const std::string& list) {
        return on_new_ground([&](const Ground& ground) {
            return quadrature_nodes(parse_list(source(list)), ground).polynomial;
        });
    };
    REQUIRE(polynomial("gauss:2, 0"));
    CHECK(polynomial("gauss:2, 0")->degree() == 3);
    CHECK(polynomial("0, 1/2, 1"));
    CHECK_FALSE(polynomial("sqrt(2)/2"));
    // The real roots may be all those of another polynomial over Q, or not.
    CHECK(polynomial("roots((tau-2)*(tau^2+1))")->degree() == 1);
    CHECK(polynomial("sqrt(2)/2, -sqrt(2)/2") == polynomial("roots(2*tau^2-1)"));
    CHECK_FALSE(polynomial("roots(tau^3-2)"));
}
