// Dual numbers against derivatives that are known, with decimals of mpmath.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <driver/dual.hpp>
#include <hvi/detail/numbers/compensated.hpp>

#include "tests/program/edges/epsilon.hpp"

namespace {

using Dual = hvi::driver::Dual<3>;
using hvi::test::eps;
namespace math = hvi::math;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Dual dual(double value, double by_0, double by_1, double by_2) {
    Dual x(value);
    x.by[0] = by_0;
    x.by[1] = by_1;
    x.by[2] = by_2;
    return x;
}

/// 3/8, as a number that has a derivative, another one, and one that is none.
const Dual three_eighths = dual(0.375, 1, -4, 0);

/// Whether a function of 3/8 has this value, and this derivative to four units in the last place.
bool is(const Dual& result, double value, double slope) {
    const double most = 4 * eps * std::abs(slope);
    return result.value == value && std::abs(result.by[0] - slope) <= most &&
           result.by[1] == -4 * result.by[0] && result.by[2] == 0;
}

}  // namespace

TEST_CASE("the derivative of each function at 3/8") {
    const Dual& x = three_eighths;
    const double v = x.value;
    CHECK(is(math::acos(x), std::acos(v), -1.078719779941187337994));
    CHECK(is(math::asin(x), std::asin(v), 1.078719779941187337994));
    CHECK(is(math::atan(x), std::atan(v), 0.8767123287671232876712));
    CHECK(is(math::cos(x), std::cos(v), -0.3662725290860475613729));
    CHECK(is(math::cosh(x), std::cosh(v), 0.3838510679136145687543));
    CHECK(is(math::exp(x), std::exp(v), 1.454991414618201336054));
    CHECK(is(math::expm1(x), std::expm1(v), 1.454991414618201336054));
    CHECK(is(math::log(x), std::log(v), 2.666666666666666666667));
    CHECK(is(math::sin(x), std::sin(v), 0.9305076219123142911495));
    CHECK(is(math::sinh(x), std::sinh(v), 1.071140346704586767299));
    CHECK(is(math::sqrt(x), std::sqrt(v), 0.8164965809277260327324));
    CHECK(is(math::tan(x), std::tan(v), 1.154941881274937930516));
    CHECK(is(math::tanh(x), std::tanh(v), 0.871579975047256117921));
}

TEST_CASE("the derivatives of powers by base and exponent") {
    const Dual& x = three_eighths;
    CHECK(is(math::pow(x, Dual(1.25)), std::pow(0.375, 1.25), 0.9781778625458045728653));
    const Dual y = x + 0.875;  // 5/4
    CHECK(is(math::pow(Dual(0.375), y), std::pow(0.375, 1.25), -0.2878276386700225568374));
    CHECK(is(math::pow(x, y), std::pow(0.375, 1.25),
             0.9781778625458045728653 - 0.2878276386700225568374));
    // Integer exponents, of bases that have no logarithm.
    CHECK(math::pow(dual(-2, 1, 0, 0), Dual(3)) == dual(-8, 12, 0, 0));
    CHECK(math::pow(dual(0, 1, 0, 0), Dual(1)) == dual(0, 1, 0, 0));
    CHECK(math::pow(dual(0, 1, 0, 0), Dual(0)) == Dual(1));
    CHECK(math::pow(dual(0, 1, 0, 0), Dual(2)) == Dual(0));
}

TEST_CASE("the rules of calculus, on numbers without rounding") {
    const Dual u = dual(1.5, 1, 0, 2);
    const Dual v = dual(-4, 0, 1, 8);
    CHECK(u + v == dual(-2.5, 1, 1, 10));
    CHECK(u - v == dual(5.5, 1, -1, -6));
    CHECK(u * v == dual(-6, -4, 1.5, 4));
    CHECK(u / v == dual(-0.375, -0.25, -0.09375, -1.25));
    CHECK(-u == dual(-1.5, -1, 0, -2));
    CHECK(2 * u - 1 == dual(2, 2, 0, 4));
    CHECK(u * u / u == u);
    Dual w = u;
    const Dual& same = w;
    w /= same;
    CHECK(w == Dual(1));
    w = u;
    w *= same;
    CHECK(w == dual(2.25, 3, 0, 6));
}

TEST_CASE("constants have no derivative where a function has no finite one") {
    CHECK(math::sqrt(Dual(0)) == Dual(0));
    CHECK(math::asin(Dual(1)) == Dual(std::asin(1.0)));
    CHECK(math::sqrt(dual(0, 1, 0, 0)).by[0] == infinity);
}

TEST_CASE("numbers are ordered by values, and equal by all parts") {
    CHECK(Dual(1) < Dual(2));
    CHECK(Dual(2) >= Dual(2));
    CHECK_FALSE(dual(1, 5, 0, 0) > dual(1, 0, 0, 0));
    CHECK(dual(1, 5, 0, 0) != Dual(1));
    CHECK(hvi::driver::variable<3>(7, 1) == dual(7, 0, 1, 0));
    CHECK(math::islessgreater(Dual(1), Dual(2)));
    CHECK_FALSE(math::islessgreater(Dual(no_number), Dual(2)));
    CHECK(math::isnormal(Dual(1)));
    CHECK_FALSE(math::isnormal(dual(0, 1, 1, 1)));
}

TEST_CASE("to the runtime they are of the format of double") {
    STATIC_REQUIRE(hvi::detail::is_supported<Dual>());
    STATIC_REQUIRE(hvi::detail::bits<Dual> == 53);
    STATIC_REQUIRE(hvi::detail::epsilon<Dual>.value == eps);
    STATIC_REQUIRE(math::computes_in<Dual>);
    STATIC_REQUIRE_FALSE(hvi::detail::is_supported<std::vector<double>>());
    CHECK(hvi::detail::is_finite(dual(1, 2, 3, 4)));
    CHECK_FALSE(hvi::detail::is_finite(dual(1, 2, infinity, 4)));
}

TEST_CASE("a size is that of the largest part, and no number where one is none") {
    CHECK(hvi::detail::abs(dual(-3, 1, -7, 2)) == Dual(7));
    CHECK(hvi::detail::abs(dual(-3, 1, -2, 2)) == Dual(3));
    for (const Dual& none :
         {dual(no_number, 1, 1, 9), dual(1, no_number, 9, 1), dual(1, 9, 1, no_number)})
        CHECK(std::isnan(hvi::detail::abs(none).value));
}

TEST_CASE("compensated sums keep what each part loses") {
    CHECK(hvi::detail::sums_are_exact<Dual>());
    const hvi::Sum<Dual> sum = hvi::two_sum(dual(1, 0x1p60, 3, 0x1p-60), dual(0x1p-60, 1, 4, 1));
    CHECK(sum.value == dual(1, 0x1p60, 7, 1));
    CHECK(sum.remainder == dual(0x1p-60, 1, 0, 0x1p-60));
}

TEST_CASE("Newton's method gives the derivatives of a solution") {
    // For u^2 + v = a and u v = b, at u = 2 and v = 3: du = (2 da - db)/5, dv = da - 4 du.
    const Dual a = dual(7, 1, 0, 5);
    const Dual b = dual(6, 0, 1, 5);
    Dual u = 2.25;
    Dual v = 2.75;
    hvi::detail::SquareMatrix<Dual> J(2);
    J(0, 0) = 2 * u;
    J(0, 1) = 1;
    J(1, 0) = v;
    J(1, 1) = u;
    hvi::detail::Factors<Dual> factors;
    REQUIRE(factors.compute(J));
    for (int i = 0; i < 200; ++i) {
        std::vector<Dual> correction{u * u + v - a, u * v - b};
        factors.solve(correction.data());
        u -= correction[0];
        v -= correction[1];
    }
    const auto near = [](const Dual& number, const std::vector<double>& parts) {
        bool all = std::abs(number.value - parts[0]) < 1e-15;
        for (std::size_t i = 0; i < 3; ++i)
            all = all && std::abs(number.by[i] - parts[i + 1]) < 1e-14;
        return all;
    };
    CHECK(near(u, {2, 0.4, -0.2, 1}));
    CHECK(near(v, {3, -0.6, 0.8, 1}));
    CHECK_FALSE(factors.compute(hvi::detail::SquareMatrix<Dual>(2)));
}
