// Functions of small angles, beside numbers of 113 bits, and turns that take them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <catch2/catch.hpp>
#include <driver/dual.hpp>
#include <hvi/detail/numbers/small_turns.hpp>

#include "flows/spin.hpp"
#include "flows/spin_in_duals.hpp"

namespace {

using hvi::math::Widest;

/// Errors of a function, in units in the last place of its values.
struct Errors {
    double largest = 0;
    double mean = 0;  ///< with signs, those of negative arguments turned
};

/// Returns the errors for |y| <= 1/2, of values that are odd in y, beside wide ones.
template <class Number, class Values, class WideValues>
Errors errors(Values value, WideValues wide_value) {
    constexpr int points = 20'000;
    Errors result;
    for (int k = -points; k <= points; ++k) {
        // NOTE: numbers near 0 as well, and all last bits.
        const Number part = static_cast<Number>(k) / points;
        const Number y = part * part * part / 2;
        if (y == 0) { continue; }
        const Widest exact = wide_value(static_cast<Widest>(y));
        int exponent = 0;
        static_cast<void>(std::frexp(static_cast<Number>(exact), &exponent));
        const auto unit =
            std::ldexp(static_cast<Number>(1), exponent - std::numeric_limits<Number>::digits);
        const auto error = static_cast<double>((static_cast<Widest>(value(y)) - exact) /
                                               static_cast<Widest>(unit));
        result.largest = std::max(result.largest, std::abs(error));
        result.mean += (y < 0 ? -error : error) / (2 * points);
    }
    return result;
}

template <class Number>
Errors errors_of_tan() {
    return errors<Number>([](Number y) { return hvi::math::small_tan(y); },
                          [](Widest y) { return hvi::math::tan(y); });
}

template <class Number>
Errors errors_of_sin() {
    return errors<Number>([](Number y) { return hvi::math::small_double_sin(y); },
                          [](Widest y) { return hvi::math::sin(2 * y); });
}

}  // namespace

TEST_CASE("functions of small turns are right to a unit in the last place, without a bias") {
    for (const Errors& error : {errors_of_tan<double>(), errors_of_sin<double>(),
                                errors_of_tan<float>(), errors_of_sin<float>()}) {
        CHECK(error.largest < 1);
        CHECK(std::abs(error.mean) < 0.02);
    }
}

TEST_CASE("functions of small turns are odd, and keep zeros and NaN") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double y : {0.0, 5e-324, 1e-160, 1e-8, 0.3, 0.5}) {
        CHECK(hvi::math::small_tan(-y) == -hvi::math::small_tan(y));
        CHECK(hvi::math::small_double_sin(-y) == -hvi::math::small_double_sin(y));
    }
    CHECK(hvi::math::small_tan(5e-324) == 5e-324);
    CHECK(hvi::math::small_double_sin(5e-324) == 1e-323);
    CHECK(std::signbit(hvi::math::small_tan(-0.0)));
    CHECK(std::isnan(hvi::math::small_tan(nan)));
    CHECK(std::isnan(hvi::math::small_double_sin(nan)));
}

TEST_CASE("turns are continuous where their angle ceases to be small") {
    // NOTE: for L_2 = 1 the speed is 13/10, and a step of 10/13 turns by 1.
    hvi::generated::Spin below, beyond;
    auto x = hvi::generated::Spin::initial(), y = x;
    const double h = 10.0 / 13;
    REQUIRE(below.step(x, h * (1 - 1e-15)).ok());
    REQUIRE(beyond.step(y, h * (1 + 1e-15)).ok());
    for (std::size_t k = 0; k < 9; ++k) { CHECK(std::abs(x.R[k] - y.R[k]) < 5e-15); }
    for (std::size_t k = 0; k < 3; ++k) { CHECK(std::abs(x.L[k] - y.L[k]) < 5e-15); }
}

TEST_CASE("a turn by no number, or one too large, fails and leaves the state") {
    hvi::generated::Spin stepper;
    for (const double L_2 : {1e200, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
        auto x = hvi::generated::Spin::initial();
        x.L[1] = L_2;
        const auto before = x;
        CAPTURE(L_2);
        CHECK(stepper.step(x, 0.25).code() == hvi::Status::Code::not_finite);
        CHECK(x.R == before.R);
        CHECK(x.L[0] == before.L[0]);
        CHECK(x.L[2] == before.L[2]);
    }
}

TEST_CASE("turns in dual numbers are those of doubles, with their derivatives") {
    using Dual = hvi::driver::Dual<1>;
    using Duals = hvi::generated::BasicSpinInDuals<Dual>;
    for (const double h : {0.25, -0.5, 0.75, 0.8, 3.0, 30.0}) {
        Duals stepper;
        auto x = Duals::initial();
        hvi::generated::Spin plain;
        auto y = hvi::generated::Spin::initial();
        x.L[1] = hvi::driver::variable<1>(y.L[1], 0);
        const double L_1 = y.L[0], L_2 = y.L[1], L_3 = y.L[2];
        const double angle = (L_2 / 2 + 4 * L_2 * L_2 * L_2 / 5) * h;
        const double by_L_2 = (0.5 + 12 * L_2 * L_2 / 5) * h;
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(plain.step(y, h).ok());
        CAPTURE(h);
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t k = 0; k < 3; ++k) { CHECK(std::abs(x.L[k].value - y.L[k]) <= 1e-15); }
        const double margin = 1e-14 * std::max(1.0, std::abs(by_L_2));
        CHECK(std::abs(x.L[0].by[0] + by_L_2 * (s * L_1 + c * L_3)) <= margin);
        CHECK(std::abs(x.L[1].by[0] - 1) <= 1e-15);
        CHECK(std::abs(x.L[2].by[0] - by_L_2 * (c * L_1 - s * L_3)) <= margin);
    }
}
