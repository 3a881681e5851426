// Methods with nodes that have no closed form: certified digits, and what stays exact.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <tuple>

#include <catch2/catch.hpp>

#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

const std::string one_to_60_digits = "1." + std::string(59, '0');

}  // namespace

TEST_CASE("Gauss nodes and weights as in the tables") {
    // Abramowitz & Stegun, Table 25.4: x_i > 0 on [-1, 1] and twice our weights
    struct Rule {
        int s;
        std::vector<std::string> x, w;
    };
    const auto rule =
        GENERATE(Rule{6,
                      {"0.238619186083196908630501721681", "0.661209386466264513661399595020",
                       "0.932469514203152027812301554494"},
                      {"0.467913934572691047389870343990", "0.360761573048138607569833513838",
                       "0.171324492379170345040296142173"}},
                 Rule{8,
                      {"0.183434642495649804939476142360", "0.525532409916328985817739049189",
                       "0.796666477413626739591553936476", "0.960289856497536231683560868569"},
                      {"0.362683783378361982965150449277", "0.313706645877887287337962201987",
                       "0.222381034453374470544355994426", "0.101228536290376259152531354310"}});
    const Tableau tableau = derive(method("gauss:" + std::to_string(rule.s)));
    const std::size_t half = rule.x.size();
    for (std::size_t i = 0; i < half; ++i) {
        const Number& above = tableau.c[half + i];
        const Number& below = tableau.c[half - 1 - i];
        CHECK((Number(2) * above - Number(1)).decimal(30) == rule.x[i]);
        CHECK((Number(1) - Number(2) * below).decimal(30) == rule.x[i]);
        CHECK((Number(2) * tableau.b[half + i]).decimal(30) == rule.w[i]);
        CHECK((Number(2) * tableau.b[half - 1 - i]).decimal(30) == rule.w[i]);
    }
}

TEST_CASE("a method known by enclosures is consistent and symplectic to 60 digits") {
    const auto name = GENERATE(as<std::string>(), "gauss:6", "gauss:8", "lobatto:8",
                               "radau-right:5", "chebyshev:7", "chebyshev:9", "fejer:11");
    CAPTURE(name);
    const Tableau tableau = derive(method(name));
    const auto& [b, A, A_tilde] = std::tie(tableau.b, tableau.A, tableau.A_tilde);
    CHECK(text(tableau.c[1]) == "none");
    CHECK(sum(b).decimal(60) == one_to_60_digits);
    for (std::size_t i = 0; i < b.size(); ++i) {
        CHECK(is_tiny(sum(A[i]) - tableau.c[i]));
        CHECK(is_tiny(sum(A_tilde[i]) - tableau.c_tilde[i]));
        for (std::size_t j = 0; j < b.size(); ++j)
            CHECK(is_tiny(b[i] * A_tilde[i][j] + b[j] * A[j][i] - b[i] * b[j]));
    }
}

TEST_CASE("what the end points make exact stays exact") {
    const Tableau tableau = derive(method("lobatto:8"));
    CHECK(tableau.c.front().is_zero());
    CHECK(tableau.c.back().is_one());
    CHECK(tableau.c_tilde.front().is_zero());
    CHECK(tableau.c_tilde.back().is_one());
    for (std::size_t j = 0; j < 8; ++j) {
        CHECK(tableau.A.front()[j].is_zero());
        CHECK(tableau.A_tilde[j].back().is_zero());
        CHECK(tableau.A.back()[j].decimal(60) == tableau.b[j].decimal(60));
    }
    CHECK(tableau.b.front().decimal(20) == number("1/56").decimal(20));
}

TEST_CASE("the middle node of an odd rule is exact") {
    CHECK(text(derive(method("gauss:7")).c[3]) == "1/2");
    CHECK(text(derive(method("chebyshev:7")).c[3]) == "1/2");
}

TEST_CASE("many stages") {
    const Tableau tableau = derive(method("gauss:20"));
    CHECK(sum(tableau.b).decimal(60) == one_to_60_digits);
    // Abramowitz & Stegun, Table 25.4: the largest of the 20 nodes
    CHECK((Number(2) * tableau.c.back() - Number(1)).decimal(15) == "0.993128599185095");
}
