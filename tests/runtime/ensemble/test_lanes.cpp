// Functions of several numbers: right, and of each number alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <catch2/catch.hpp>
#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/lanes/lanes.hpp>

namespace {

using Lane = hvi::Lanes<double, 8>;

/// Whether a number has equal results at any place among others.
template <class F>
bool is_of_each_alone(F f, double least, double most) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-6, 12), sign(-1, 1);
    const auto number = [&] {
        const double x = std::copysign(std::pow(10, exponent(random)), sign(random));
        return std::fmin(std::fmax(x, least), most);
    };
    for (int trial = 0; trial < 2000; ++trial) {
        const double x = number();
        Lane::Row first{};
        f(Lane(x)).store(first);
        for (std::size_t place = 0; place < 8; ++place) {
            Lane::Row row{}, result{};
            for (std::size_t i = 0; i < 8; ++i) { row.set(i, i == place ? x : number()); }
            if (trial % 3 == 0) {
                row.set((place + 1) % 8, std::numeric_limits<double>::quiet_NaN());
            }
            f(Lane(row)).store(result);
            if (std::memcmp(&result[place], &first[0], sizeof(double)) != 0) { return false; }
        }
    }
    return true;
}

/// The largest error of f, in units in the last place, up to |x| = most.
template <class F, class Reference>
double error(F f, Reference reference, double most) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(-most, most);
    double worst = 0;
    for (int trial = 0; trial < 50000; ++trial) {
        const double x = uniform(random);
        Lane::Row row{};
        f(Lane(x)).store(row);
        const long double right = reference(static_cast<long double>(x));
        const double size = std::abs(static_cast<double>(right));
        const double unit = std::nextafter(size, 1e300) - size;
        worst = std::fmax(
            worst, static_cast<double>(std::abs(static_cast<long double>(row[3]) - right)) / unit);
    }
    return worst;
}

}  // namespace

#define HVI_FUNCTION(name) [](const auto& x) { return hvi::math::name(x); }
#define HVI_REFERENCE(name) [](long double x) { return std::name(x); }

TEST_CASE("functions of lanes do not look at neighbours") {
    CHECK(is_of_each_alone(HVI_FUNCTION(sin), -1e12, 1e12));
    CHECK(is_of_each_alone(HVI_FUNCTION(cos), -1e12, 1e12));
    CHECK(is_of_each_alone(HVI_FUNCTION(tan), -1e12, 1e12));
    CHECK(is_of_each_alone(HVI_FUNCTION(exp), -700, 700));
    CHECK(is_of_each_alone(HVI_FUNCTION(expm1), -700, 700));
    CHECK(is_of_each_alone(HVI_FUNCTION(sinh), -700, 700));
    CHECK(is_of_each_alone(HVI_FUNCTION(cosh), -700, 700));
    CHECK(is_of_each_alone(HVI_FUNCTION(tanh), -700, 700));
    CHECK(is_of_each_alone(HVI_FUNCTION(atan), -1e12, 1e12));
    CHECK(is_of_each_alone(HVI_FUNCTION(asin), -1, 1));
    CHECK(is_of_each_alone(HVI_FUNCTION(acos), -1, 1));
    CHECK(is_of_each_alone(HVI_FUNCTION(log), 1e-300, 1e12));
    CHECK(is_of_each_alone(HVI_FUNCTION(sqrt), 0, 1e12));
    CHECK(is_of_each_alone([](const auto& x) { return hvi::math::pow(x, -1.5); }, 1e-100, 1e12));
}

TEST_CASE("sin, cos and tan of lanes are right, near and far") {
    for (const double most : {0.7, 10.0, 1e5, 1e9}) {
        CHECK(error(HVI_FUNCTION(sin), HVI_REFERENCE(sin), most) < 2.5);
        CHECK(error(HVI_FUNCTION(cos), HVI_REFERENCE(cos), most) < 2.5);
        CHECK(error(HVI_FUNCTION(tan), HVI_REFERENCE(tan), most) < 4);
    }
}

TEST_CASE("masks choose lane by lane, and a NaN is less than nothing") {
    Lane::Row row{};
    for (std::size_t i = 0; i < 8; ++i) { row.set(i, static_cast<double>(i)); }
    row.set(6, std::numeric_limits<double>::quiet_NaN());
    const Lane x(row);
    const auto small = x < Lane(3.0);
    CHECK(any(small));
    CHECK_FALSE(all(small));
    CHECK(all(small | !small));
    CHECK_FALSE(any(small & !small));
    Lane::Row chosen{};
    select(small, Lane(1.0), Lane(0.0)).store(chosen);
    for (std::size_t i = 0; i < 8; ++i) { CHECK(chosen[i] == (i < 3 ? 1.0 : 0.0)); }
    select(x <= x, Lane(1.0), Lane(0.0)).store(chosen);
    for (std::size_t i = 0; i < 8; ++i) { CHECK(chosen[i] == (i == 6 ? 0.0 : 1.0)); }
}
