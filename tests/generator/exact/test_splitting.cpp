// Splittings: their coefficients beside those that their authors print, and their orders.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/exact/methods/splitting.hpp"
#include "generator/exact/methods/splitting_orders.hpp"

using namespace hvi::gen;

namespace {

Splitting named(const std::string& name) {
    return on_new_ground([&](const Ground& ground) { return splitting(ground, name); });
}

using OrdersOfParts = std::vector<std::size_t>;

}  // namespace

// Laskar & Robutel, Celest. Mech. Dyn. Astron. 80 (2001) 39, Table 1: SABA_3 has c_1 = 1/2 -
// sqrt(15)/10, c_2 = sqrt(15)/10, d_1 = 5/18 and d_2 = 4/9.
TEST_CASE("saba:3 has the coefficients of Laskar & Robutel") {
    const Splitting saba = named("saba:3");
    REQUIRE(saba.a.size() == 4);
    REQUIRE(saba.b.size() == 3);
    CHECK(saba.a[0].decimal(30) == "0.112701665379258311482073460022");
    CHECK(saba.a[1].decimal(30) == "0.387298334620741688517926539978");
    CHECK((saba.a[1] - saba.a[2]).is_zero());
    CHECK((saba.a[0] - saba.a[3]).is_zero());
    CHECK((saba.b[0] - Number(5) / Number(18)).is_zero());
    CHECK((saba.b[1] - Number(4) / Number(9)).is_zero());
}

// Table 3 of Blanes et al., Appl. Numer. Math. 68 (2013) 58.
TEST_CASE("the other splittings have the digits that are printed") {
    const Splitting blanes = named("blanes:10.6.4");
    REQUIRE(blanes.a.size() == 9);
    CHECK(blanes.a[0].decimal(20) == "0.038094497422412195457");
    CHECK(blanes.a[4].decimal(20) == "-0.65386122583278670938");
    CHECK(blanes.b[3].decimal(20) == "-0.017375381959065093006");
    const Splitting mclachlan = named("mclachlan:8.4");
    REQUIRE(mclachlan.b.size() == 5);
    CHECK(mclachlan.a[2].decimal(16) == "-0.09326381495814967");
    CHECK(mclachlan.b[2].decimal(20) == "-1.0735000196344057526");
}

TEST_CASE("a splitting is a palindrome with sums 1") {
    for (const char* name :
         {"strang", "saba:2", "saba:5", "mclachlan:8.2", "mclachlan:8.4", "blanes:10.6.4"}) {
        CAPTURE(name);
        const Splitting it = named(name);
        REQUIRE(it.a.size() == it.b.size() + 1);
        Number a(0), b(0);
        for (std::size_t k = 0; k < it.a.size(); ++k) {
            a = a + it.a[k];
            CHECK((it.a[k] - it.a[it.a.size() - 1 - k]).is_zero());
        }
        for (std::size_t k = 0; k < it.b.size(); ++k) {
            b = b + it.b[k];
            CHECK((it.b[k] - it.b[it.b.size() - 1 - k]).is_zero());
        }
        CHECK(a.is_one());
        CHECK(b.is_one());
    }
}

TEST_CASE("orders for parts of different sizes are those of the authors") {
    CHECK(splitting_orders(named("strang")) == OrdersOfParts{2, 2});
    CHECK(splitting_orders(named("saba:2")) == OrdersOfParts{4, 2});
    CHECK(splitting_orders(named("saba:3")) == OrdersOfParts{6, 2});
    CHECK(splitting_orders(named("mclachlan:8.2")) == OrdersOfParts{8, 2});
    CHECK(splitting_orders(named("saba:6")) == OrdersOfParts{12, 2});
    CHECK(splitting_orders(named("mclachlan:8.4")) == OrdersOfParts{8, 4});
    CHECK(splitting_orders(named("blanes:10.6.4")) == OrdersOfParts{10, 6, 4});
}

TEST_CASE("a coefficient that is off by 1e-20 takes the order away") {
    Splitting it = named("blanes:10.6.4");
    Number off(1);
    for (int k = 0; k < 20; ++k) { off = off / Number(10); }
    it.a[0] = it.a[0] + off;
    it.a[8] = it.a[8] - off;
    CHECK(splitting_orders(it) == OrdersOfParts{1});
}

TEST_CASE("substeps make the flows of two parts") {
    for (const char* name : {"strang", "saba:4", "blanes:10.6.4"}) {
        CAPTURE(name);
        const Splitting it = named(name);
        const NumberVector steps = substeps(it);
        REQUIRE(steps.size() == 2 * it.b.size());
        CHECK((steps.front() - it.a.front()).is_zero());
        CHECK((steps.back() - it.a.back()).is_zero());
        for (std::size_t k = 0; k < it.b.size(); ++k) {
            CHECK((steps[2 * k] + steps[2 * k + 1] - it.b[k]).is_zero());
        }
        for (std::size_t k = 1; k + 1 < it.a.size(); ++k) {
            CHECK((steps[2 * k - 1] + steps[2 * k] - it.a[k]).is_zero());
        }
    }
}
