// The functions of <hvi/detail/numbers/more_math.hpp>, one by one and side by side, against
// decimals of mpmath, and those of dual numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <driver/dual.hpp>
#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/numbers/more_math.hpp>

#include "tests/runtime/scalars/wide.hpp"

namespace {

namespace math = hvi::math;
using math::Widest;
using scalars::Wide;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool is_at(Widest value, const std::string& decimal, int units) {
    const Wide unit = Wide::of(units * hvi::detail::epsilon<Widest> / 2);
    return (Wide::of(value) - Wide(decimal)).absolute() <= unit;
}

using Lane = hvi::Lanes<double, 8>;

template <class F>
std::array<double, 8> in_lanes(const std::array<double, 8>& x, F f) {
    Lane::Row row{};
    for (std::size_t i = 0; i < 8; ++i) { row.set(i, x[i]); }
    f(Lane(row)).store(row);
    std::array<double, 8> result{};
    for (std::size_t i = 0; i < 8; ++i) { result[i] = row[i]; }
    return result;
}

/// The largest error in lanes between two numbers, in units in the last place.
template <class F, class Exact>
double error(double from, double to, F f, Exact exact) {
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
        std::array<double, 8> x{};
        for (int k = 0; k < 8; ++k) {
            x[static_cast<std::size_t>(k)] = from + (to - from) * (8 * i + k + 0.37) / 32000;
        }
        const auto y = in_lanes(x, f);
        for (std::size_t k = 0; k < 8; ++k) {
            const long double wanted = exact(static_cast<long double>(x[k]));
            const double size = std::abs(static_cast<double>(wanted));
            const double unit = std::nextafter(size, 1e300) - size;
            const auto off = static_cast<double>(std::abs(static_cast<long double>(y[k]) - wanted));
            worst = std::fmax(worst, off == off ? off / unit : 1e300);
        }
    }
    return worst;
}

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Whether a function of lanes has in each lane the value of that number alone.
template <class F, class Alone>
bool is_alone(F f, Alone alone, const std::array<double, 8>& x) {
    const auto y = in_lanes(x, f);
    bool all = true;
    for (std::size_t i = 0; i < 8; ++i) { all = all && is_same(y[i], alone(x[i])); }
    return all;
}

using Dual = hvi::driver::Dual<2>;

/// Whether it has this slope to a few units in the last place.
bool has_slope(const Dual& x, double slope) {
    return std::abs(x.by[0] - slope) <= 8 * 0x1p-53 * std::abs(slope) && x.by[1] == 0;
}

}  // namespace

TEST_CASE("each function at 3/8, or at 11/8") {
    const Widest x = Widest(3) / 8;
    CHECK(is_at(math::log10(x), "-0.425968732272281148346188780918363771104440780195629", 2));
    CHECK(is_at(math::cbrt(x), "0.7211247851537041911608191553900547941959346267496752", 2));
    CHECK(is_at(math::asinh(x), "0.3667246042301367654909666603586211269867001463846966", 2));
    CHECK(is_at(math::acosh(x + 1), "0.8410193220114457384894851961263047161330910062908026", 4));
    CHECK(is_at(math::atanh(x), "0.3942286801821350847305921223694708301480527498344497", 2));
    CHECK(is_at(math::erf(x), "0.4041169094348222983238250859191217675304340467510845", 2));
    CHECK(is_at(math::erfc(x), "0.5958830905651777016761749140808782324695659532489154", 2));
    CHECK(is_at(math::atan2(x, Widest(-5) / 4),
                "2.8501358591119261464670387618466116906940018003630404", 8));
}

TEST_CASE("of numbers side by side they are right to a few units in the last place") {
    using L = long double;
    // clang-format off
    CHECK(error(1e-3, 100, [](auto x) { return math::log10(x); }, [](L x) { return std::log10(x); }) < 4);
    CHECK(error(-20, 20, [](auto x) { return math::cbrt(x); }, [](L x) { return std::cbrt(x); }) < 4);
    CHECK(error(-20, 20, [](auto x) { return math::asinh(x); }, [](L x) { return std::asinh(x); }) < 4);
    CHECK(error(1, 20, [](auto x) { return math::acosh(x); }, [](L x) { return std::acosh(x); }) < 4);
    CHECK(error(-1, 1, [](auto x) { return math::atanh(x); }, [](L x) { return std::atanh(x); }) < 4);
    CHECK(error(-6, 6, [](auto x) { return math::erf(x); }, [](L x) { return std::erf(x); }) < 4);
    CHECK(error(-6, 26, [](auto x) { return math::erfc(x); }, [](L x) { return std::erfc(x); }) < 8);
    CHECK(error(-6, 6, [](auto x) { return math::atan2(x, -2.0); },
                [](L x) { return std::atan2(x, -2.0L); }) < 4);
    CHECK(error(-6, 6, [](auto x) { return math::atan2(-2.0, x); },
                [](L x) { return std::atan2(-2.0L, x); }) < 4);
    // clang-format on
}

TEST_CASE("far out, and where they are not defined, they are what they are of one number") {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::array<double, 8> x{-infinite, -1e300, -1.0, 0.0, 1.0, 1e300, infinite, none};
    CHECK(is_alone([](auto a) { return math::erf(a); }, [](double a) { return std::erf(a); }, x));
    CHECK(is_alone([](auto a) { return math::erfc(a); }, [](double a) { return std::erfc(a); }, x));
    CHECK(
        is_alone([](auto a) { return math::acosh(a); }, [](double a) { return std::acosh(a); }, x));
    CHECK(is_alone([](auto a) { return math::cbrt(a); }, [](double a) { return std::cbrt(a); }, x));
}

TEST_CASE("functions with kinks, and of NaN NaN") {
    CHECK(math::abs<double>(-3) == 3);
    CHECK_FALSE(std::signbit(math::abs<double>(-0.0)));
    CHECK(math::sign<double>(-3) == -1);
    CHECK(math::sign<double>(-0.0) == 0);
    CHECK(math::sign<double>(5e-324) == 1);
    CHECK(math::min<double>(2, 3) == 2);
    CHECK(math::min<double>(3, 2) == 2);
    CHECK(math::max<double>(2, 3) == 3);
    CHECK(math::max<double>(3, 2) == 3);
    CHECK(math::max<Widest>(3, 2) == 3);
    CHECK(math::if_less<double>(1, 1, 2, 3) == 3);
    CHECK(math::if_at_most<double>(1, 1, 2, 3) == 2);
    for (const double other : {-1.0, 0.0, none}) {
        CHECK(std::isnan(math::min<double>(none, other)));
        CHECK(std::isnan(math::min<double>(other, none)));
        CHECK(std::isnan(math::max<double>(none, other)));
        CHECK(std::isnan(math::max<double>(other, none)));
    }
    CHECK(std::isnan(math::abs<double>(none)));
    CHECK(std::isnan(math::sign<double>(none)));
    CHECK(math::if_less<double>(none, 1, 2, 3) == 3);
    CHECK(math::if_at_most<double>(1, none, 2, 3) == 3);
}

TEST_CASE("side by side they choose in each lane") {
    const std::array<double, 8> x{-2, -1, -0.0, 0.0, 0.5, 1, 2, none};
    CHECK(is_alone([](auto a) { return math::abs<Lane>(a); }, [](double a) { return std::abs(a); },
                   x));
    CHECK(is_alone([](auto a) { return math::sign<Lane>(a); },
                   [](double a) { return math::sign<double>(a); }, x));
    CHECK(is_alone([](auto a) { return math::min<Lane>(a, 0.5); },
                   [](double a) { return math::min<double>(a, 0.5); }, x));
    CHECK(is_alone([](auto a) { return math::max<Lane>(0.5, a); },
                   [](double a) { return math::max<double>(0.5, a); }, x));
    CHECK(is_alone([](auto a) { return math::if_less<Lane>(a, 0.5, a, -a); },
                   [](double a) { return a < 0.5 ? a : -a; }, x));
    CHECK(is_alone([](auto a) { return math::if_at_most<Lane>(a, 0.5, a, 1.0); },
                   [](double a) { return a <= 0.5 ? a : 1.0; }, x));
}

TEST_CASE("the derivative of each function at 3/8, or at 11/8") {
    const Dual x = hvi::driver::variable<2>(0.375, 0);
    CHECK(has_slope(math::log10(x), 1.158118618408671540403));
    CHECK(has_slope(math::cbrt(x), 0.6409998090255148365874));
    CHECK(has_slope(math::asinh(x), 0.9363291775690445115476));
    CHECK(has_slope(math::acosh(x + 1), 1.059625885652035045226));
    CHECK(has_slope(math::atanh(x), 1.163636363636363636364));
    CHECK(has_slope(math::erf(x), 0.9803528095459078677994));
    CHECK(has_slope(math::erfc(x), -0.9803528095459078677994));
    CHECK(has_slope(math::atan2(x, Dual(2)), 2 / (4 + 0.140625)));
    CHECK(has_slope(math::atan2(Dual(2), x), -2 / (4 + 0.140625)));
    CHECK(has_slope(math::abs<Dual>(-x), 1));
    CHECK(has_slope(math::sign<Dual>(x), 0));
    CHECK(has_slope(math::min<Dual>(x, 2 * x), 1));
    CHECK(has_slope(math::max<Dual>(x, 2 * x), 2));
}
