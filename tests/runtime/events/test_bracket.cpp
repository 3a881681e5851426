// Zeros between two numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <limits>
#include <utility>

#include <catch2/catch.hpp>
#include <hvi/detail/numbers/bracket.hpp>

namespace {

/// The zero of f, and how often f was called for it.
template <class Function>
std::pair<double, int> zero(Function f, double a, double b, double tolerance = 1e-15) {
    int calls = 0;
    const auto counted = [&](double x) {
        ++calls;
        return f(x);
    };
    const auto found = hvi::detail::narrowed<double>({a, b, f(a), f(b)}, tolerance, counted);
    CHECK(std::min(found.at_a, found.at_b) <= 0);
    CHECK(std::max(found.at_a, found.at_b) >= 0);
    return {found.best(), calls};
}

}  // namespace

TEST_CASE("zeros of smooth functions in few calls") {
    const auto cubic = zero([](double x) { return x * x * x - 2; }, 0, 2);
    CHECK(std::abs(cubic.first - std::cbrt(2.0)) < 1e-15);
    CHECK(cubic.second < 14);
    const auto cosine = zero([](double x) { return std::cos(x) - x; }, 1, 0);
    CHECK(std::abs(std::cos(cosine.first) - cosine.first) < 3e-16);
    CHECK(cosine.second < 12);
    const auto line = zero([](double x) { return 3 * x - 1; }, 0, 1);
    CHECK(std::abs(line.first - 1.0 / 3) < 1e-15);
    CHECK(line.second < 6);
}

TEST_CASE("zeros where interpolation helps nothing") {
    const auto flat = zero([](double x) { return std::pow(x - 0.7, 9); }, 0, 1, 1e-9);
    CHECK(std::abs(flat.first - 0.7) < 1e-2);
    CHECK(flat.second < 120);
    const auto jump = zero([](double x) { return x < 0.3 ? -1.0 : 1e9; }, 0, 1);
    CHECK(std::abs(jump.first - 0.3) < 1e-14);
    CHECK(jump.second < 120);
}

TEST_CASE("a zero at an end, and a function that has no value") {
    CHECK(zero([](double x) { return x; }, 0, 1).first == 0);
    CHECK(zero([](double x) { return x - 1; }, 0, 1).first == 1);
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto found =
        hvi::detail::narrowed<double>({0, 1, -1, 1}, 1e-15, [&](double) { return none; });
    CHECK(std::isnan(found.at_a));
}
