// Truncated power series.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>
#include <hvi/detail/coefficients/series.hpp>
#include <hvi/detail/numbers/pair.hpp>

#include "ball.hpp"
#include "numbers.hpp"

using hvi::detail::Pair;
using hvi::detail::Series;
using parameter::Ball;
using parameter::Numbers;
using parameter::relative_error;

namespace {

constexpr std::size_t length = 9;

/// A third of the coefficients are 0.
template <class S>
Series<Pair<S>, length> draw(Numbers& numbers) {
    Series<Pair<S>, length> series;
    for (std::size_t j = 0; j < length; ++j) {
        const Pair<S> c = numbers.pair<S>(-3, 3);
        if (numbers.between(0, 3) > 1) { series[j] = c.hi < 0 ? -c : c; }
    }
    return series;
}

template <class S>
std::array<Ball, length> exact(const Series<Pair<S>, length>& series) {
    std::array<Ball, length> result;
    for (std::size_t j = 0; j < length; ++j) { result[j] = Ball::of(series[j]); }
    return result;
}

/// Whether a value is near. Precondition: the terms are positive, so that nothing cancels.
template <class S>
bool is_near(const Pair<S>& value, const Ball& expected) {
    return expected.bound() == 0 ? value.hi == 0 : relative_error(value, expected) < 5;
}

}  // namespace

TEMPLATE_TEST_CASE("series are added and multiplied as polynomials are, and cut off", "",
                   HVI_WORK_SCALARS) {
    using S = TestType;
    const unsigned seed = 4;
    Numbers numbers(seed);
    CAPTURE(seed);
    for (int i = 0; i < 200; ++i) {
        const auto a = draw<S>(numbers);
        const auto b = draw<S>(numbers);
        const auto x = exact(a);
        const auto y = exact(b);
        const auto sum = a + b;
        const auto product = a * b;
        for (std::size_t j = 0; j < length; ++j) {
            Ball coefficient;
            for (std::size_t k = 0; k <= j; ++k) { coefficient = coefficient + x[k] * y[j - k]; }
            CHECK(is_near(sum[j], x[j] + y[j]));
            CHECK(is_near(product[j], coefficient));
        }
    }
}

TEMPLATE_TEST_CASE("a series is summed from a coefficient on", "", HVI_WORK_SCALARS) {
    using S = TestType;
    const unsigned seed = 5;
    Numbers numbers(seed);
    const auto a = draw<S>(numbers);
    Pair<S> t = numbers.pair<S>(-2, 0);
    t = t.hi < 0 ? -t : t;
    CAPTURE(seed);
    for (std::size_t first = 0; first <= length; ++first) {
        Ball sum;
        Ball power(1.0);
        for (std::size_t j = first; j < length; ++j) {
            sum = sum + power * Ball::of(a[j]);
            power = power * Ball::of(t);
        }
        CHECK(is_near(a.sum_from(first, t), sum));
    }
}

TEST_CASE("a constant is a series") {
    const Series<Pair<double>, 3> two(Pair<double>{2.0});
    CHECK((two[0].hi == 2 && two[1].hi == 0 && two[2].hi == 0));
}
