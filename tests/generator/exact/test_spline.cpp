// B-splines: values, integrals, and which of them there are.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/generator/exact/function.hpp"
#include "tests/generator/exact/refusals.hpp"

using namespace hvi::gen;

namespace {

/// bspline(k,0), bspline(k,1), ... as the items of a basis, number i first.
std::string rotated(long degree, long count, long i) {
    std::string text;
    for (long j = 0; j < count; ++j) {
        text += fmt::format("{}bspline({},{})", j == 0 ? "" : ", ", degree, (i + j) % count);
    }
    return text;
}

}  // namespace

TEST_CASE("hat functions") {
    const std::string hats = ", bspline(1,2)";
    CHECK(has_value("bspline(1,0)" + hats, "1/8", "3/4"));
    CHECK(has_value("bspline(1,0)" + hats, "1/2", "0"));
    CHECK(has_value("bspline(1,0)" + hats, "sqrt(2)/2", "0"));
    CHECK(has_value("bspline(1,1)" + hats, "1/8", "1/4"));
    CHECK(has_value("bspline(1,1)" + hats, "1/2", "1"));
    CHECK(has_value("bspline(1,1)" + hats, "sqrt(2)/2", "2-sqrt(2)"));
    CHECK(has_value("bspline(1,2)", "3/4", "1/2"));
    CHECK(has_value("bspline(1,2)", "1", "1"));
    CHECK(integrates("bspline(1,1)" + hats, "1", "1/2"));
    CHECK(integrates("bspline(1,1)" + hats, "1/2", "1/4"));
    CHECK(integrates("bspline(1,2)", "1/2", "0"));
    CHECK(integrates("bspline(1,2)", "sqrt(2)/2", "3/4-sqrt(2)/2"));
}

TEST_CASE("piecewise constants take the value on the right") {
    const std::string both = ", bspline(0,1)";
    CHECK(has_value("bspline(0,0)" + both, "1/4", "1"));
    CHECK(has_value("bspline(0,0)" + both, "1/2", "0"));
    CHECK(has_value("bspline(0,1)", "1/2", "1"));
    CHECK(has_value("bspline(0,1)", "1", "1"));
    CHECK(integrates("bspline(0,1)", "3/4", "1/4"));
}

TEST_CASE("a cubic by hand") {
    // on the knots 0, 0, 0, 0, 1/2, 1, 1, 1, 1
    const std::string all = ", bspline(3,4)";
    CHECK(has_value("bspline(3,0)" + all, "1/4", "1/8"));
    CHECK(has_value("bspline(3,1)" + all, "1/2", "1/4"));
    CHECK(has_value("bspline(3,2)" + all, "1/2", "1/2"));
    CHECK(has_value("bspline(3,2)" + all, "1/4", "1/4"));
    CHECK(has_value("bspline(3,3)" + all, "1/4", "1/32"));
}

TEST_CASE("integrals are (t_(i+k+1) - t_i)/(k+1), and the sum is 1") {
    for (long k = 0; k <= 3; ++k) {
        for (long count = k + 1; count <= k + 4; ++count) {
            const long m = count - k;
            const auto knot = [&](long i) { return std::clamp(i - k, 0L, m); };
            std::string sum = "0";
            for (long i = 0; i < count; ++i) {
                CAPTURE(k, count, i);
                const long length = knot(i + k + 1) - knot(i);
                CHECK(integrates(rotated(k, count, i), "1",
                                 fmt::format("{}/{}", length, m * (k + 1))));
                sum += fmt::format("+bspline({},{})", k, i);
            }
            CHECK(constant(sum) == "1");
        }
    }
}

TEST_CASE("Bernstein's polynomials are the B-splines on one interval") {
    CHECK(constant("bspline(3,1)-3*tau*(1-tau)^2+0*bspline(3,3)") == "0");
    CHECK(constant("bspline(2,0)-(1-tau)^2+0*bspline(2,2)") == "0");
}

TEST_CASE("products with other functions") {
    const std::string hats = ", bspline(1,2)";
    CHECK(integrates("tau*bspline(1,1)" + hats, "1", "1/4"));
    CHECK(integrates("bspline(1,1)*bspline(1,2)", "1", "1/12"));
    CHECK(integrates("bspline(1,1)*exp(tau)" + hats, "1", "2*e-4*exp(1/2)+2"));
    CHECK(integrates("bspline(0,1)/(1+tau)", "1", "log(4/3)"));
    CHECK(integrates("bspline(0,1)*cos(pi*tau)", "1", "-1/pi"));
    // sqrt(pi)/2 (erfi(1) - erfi(1/2)), by mpmath
    CHECK(integral_digits("bspline(0,1)*exp(tau^2)", "1") ==
          "0.91766464172355938514162845544997148408007199258780");
}

TEST_CASE("hat functions make a method") {
    const Tableau tableau = derive(method("bspline(1,0), bspline(1,1), bspline(1,2)", "0, 1/2, 1"));
    CHECK(same(tableau.b, {"1/4", "1/2", "1/4"}));
    CHECK(same(tableau.A[1], {"1/4", "1/4", "0"}));
    CHECK(derive(method("1, bspline(1,1), bspline(1,2)", "0, 1/2, 1")).b.size() == 3);
    CHECK(derive(method("bspline(1,0), bspline(1,1), bspline(2,2)", "0, 1/2, 1")).b.size() == 3);
    CHECK(derive(method("bspline(1,0), bspline(1,1)", "-1, 2")).b.size() == 2);
}

TEST_CASE("B-splines that are refused") {
    Refusal answer = refused("1, bspline(2,1)", "0, 1");
    CHECK(answer.status == 2);
    CHECK(answer.marked == "1, [bspline(2,1)]");
    CHECK(answer.says("come as 3 or more"));
    CHECK(refused("1, bspline(1,64)", "0, 1").marked == "1, bspline(1,[64])");
    CHECK(refused("1, bspline(64,1)", "0, 1").marked == "1, bspline([64],1)");
    CHECK(refused("1, bspline(1,-1)", "0, 1").marked == "1, bspline(1,[-1])");
    CHECK(refused("1, bspline(1,1/2)", "0, 1").marked == "1, bspline(1,[1/2])");
    CHECK(refused("1, bspline(k,1)", "0, 1").marked == "1, bspline([k],1)");
    CHECK(refused("1, bspline(1,1)", "0, bspline(1,1)").status == 2);
    CHECK(refused("1, exp(bspline(1,2))", "0, 1").says("inside another function"));
    CHECK(refused("1, bspline(1,2)", "0, w").says("free parameter"));
    CHECK(refused("bspline(1,0), bspline(1,2)", "0, 1").says("constants are not in the span"));
}
