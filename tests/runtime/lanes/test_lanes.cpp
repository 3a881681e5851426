// Numbers in lanes: what they compute, against one at a time in more digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/lanes/lane_products.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>

namespace {

using hvi::Lanes;

template <std::size_t count>
std::array<double, count> values(const Lanes<double, count>& x) {
    typename Lanes<double, count>::Row row;
    x.store(row);
    std::array<double, count> result{};
    for (std::size_t i = 0; i < count; ++i) { result[i] = row[i]; }
    return result;
}

/// The largest distance, in units in the last place, of f in lanes from `exact` in more digits.
template <class InLanes, class Exact>
double farthest(const std::vector<double>& places, InLanes f, Exact exact) {
    constexpr std::size_t count = 8;
    double largest = 0;
    for (std::size_t first = 0; first + count <= places.size(); first += count) {
        std::array<double, count> x{};
        std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(first), count, x.begin());
        const auto y = values(f(Lanes<double, count>(hvi::detail::lane_row(x))));
        for (std::size_t i = 0; i < count; ++i) {
            const long double wanted = exact(static_cast<long double>(x[i]));
            const auto size = static_cast<double>(std::fabs(wanted));
            const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
            largest = std::max(
                largest,
                static_cast<double>(std::fabs(static_cast<long double>(y[i]) - wanted)) / ulp);
        }
    }
    return largest;
}

std::vector<double> between(double from, double to) {
    constexpr int count = 4000;
    std::vector<double> result;
    for (int i = 0; i < count; ++i) { result.push_back(from + (to - from) * (i + 0.37) / count); }
    return result;
}

}  // namespace

TEST_CASE("functions in lanes are right to a few units in the last place") {
    namespace m = hvi::math;
    const auto near = between(-20, 20);
    const auto positive = between(1e-3, 100);
    const auto inside = between(-1, 1);
    using L = long double;
    CHECK(farthest(
              near, [](auto x) { return m::sin(x); }, [](L x) { return std::sin(x); }) < 2);
    CHECK(farthest(
              near, [](auto x) { return m::cos(x); }, [](L x) { return std::cos(x); }) < 2);
    CHECK(farthest(
              near, [](auto x) { return m::tan(x); }, [](L x) { return std::tan(x); }) < 4);
    CHECK(farthest(
              near, [](auto x) { return m::exp(x); }, [](L x) { return std::exp(x); }) < 2);
    CHECK(farthest(
              near, [](auto x) { return m::expm1(x); }, [](L x) { return std::expm1(x); }) < 4);
    CHECK(farthest(
              near, [](auto x) { return m::sinh(x); }, [](L x) { return std::sinh(x); }) < 4);
    CHECK(farthest(
              near, [](auto x) { return m::cosh(x); }, [](L x) { return std::cosh(x); }) < 4);
    CHECK(farthest(
              near, [](auto x) { return m::tanh(x); }, [](L x) { return std::tanh(x); }) < 4);
    CHECK(farthest(
              near, [](auto x) { return m::atan(x); }, [](L x) { return std::atan(x); }) < 4);
    CHECK(farthest(
              inside, [](auto x) { return m::asin(x); }, [](L x) { return std::asin(x); }) < 4);
    CHECK(farthest(
              inside, [](auto x) { return m::acos(x); }, [](L x) { return std::acos(x); }) < 4);
    CHECK(farthest(
              positive, [](auto x) { return m::log(x); }, [](L x) { return std::log(x); }) < 4);
    CHECK(farthest(
              positive, [](auto x) { return m::sqrt(x); }, [](L x) { return std::sqrt(x); }) <=
          0.5001);
    CHECK(farthest(
              positive, [](auto x) { return m::pow(x, -1.75); },
              [](L x) { return std::pow(x, -1.75L); }) < 4);
    // Far from 0 the argument is reduced with all digits of pi.
    CHECK(farthest(
              between(1e6, 1e9), [](auto x) { return m::sin(x); },
              [](L x) { return std::sin(x); }) < 2);
}

TEST_CASE("a function that is not defined in one lane is NaN there, and nowhere else") {
    const Lanes<double, 4> x(hvi::detail::lane_row<double, 4>({4.0, -1.0, 9.0, 0.25}));
    for (const auto& y :
         {values(hvi::math::sqrt(x)), values(hvi::math::log(x)), values(hvi::math::pow(x, 0.5))}) {
        CHECK(std::isfinite(y[0]));
        CHECK(std::isnan(y[1]));
        CHECK(std::isfinite(y[2]));
        CHECK(std::isfinite(y[3]));
    }
}

TEST_CASE("places that are left over are copies of the last lane") {
    hvi::detail::LaneRow<double, 5> row = hvi::detail::lane_row<double, 5>({1, 2, 3, 4, 5});
    REQUIRE(row.places == 8);
    CHECK(row[7] == 5);
    row.set(4, 6);
    CHECK(row[7] == 6);
    row.set(0, 9);
    CHECK(row[7] == 6);
    CHECK(sum_of_lanes(Lanes<double, 5>(row)) == 24);
    CHECK(sum(Lanes<double, 5>(row)) == 42);
}

TEST_CASE("a matrix times numbers in lanes") {
    const double matrix[3][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
    const auto x = hvi::detail::lane_row<double, 3>({1, 10, 100});
    const auto y =
        values(hvi::detail::product(hvi::detail::lane_columns(matrix), x, Lanes<double, 3>(0.5)));
    CHECK(y == std::array<double, 3>{321.5, 654.5, 1087.5});
}

TEST_CASE("functions made of exp are what they are far out, and NaN of NaN") {
    namespace m = hvi::math;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::array<double, 6> places{-infinite, -1e300, 1e300, infinite, nan, 0.0};
    const Lanes<double, 6> x(hvi::detail::lane_row(places));
    const auto check = [&](const auto& lanes, const auto& f) {
        const auto found = values(lanes);
        for (std::size_t i = 0; i < places.size(); ++i) {
            INFO(places[i]);
            CHECK((std::isnan(places[i]) ? std::isnan(found[i]) : found[i] == f(places[i])));
        }
    };
    check(m::exp(x), [](double a) { return std::exp(a); });
    check(m::expm1(x), [](double a) { return std::expm1(a); });
    check(m::sinh(x), [](double a) { return std::sinh(a); });
    check(m::cosh(x), [](double a) { return std::cosh(a); });
    check(m::tanh(x), [](double a) { return std::tanh(a); });
}
