// Motion of free symmetric bodies, beside closed forms and implicit steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <catch2/catch.hpp>
#include <hvi/detail/groups/turn_about_momentum.hpp>

#include "flows/lagrange.hpp"
#include "flows/lagrange_gauss.hpp"
#include "flows/symmetric.hpp"
#include "tests/runtime/flows/turns_by_series.hpp"

using namespace flow_test;

TEST_CASE("a body turns about its angular momentum by an exponential") {
    const WideMatrix R = exponential({0.3L, -0.8L, 1.1L});
    for (const std::array<double, 3>& L :
         {std::array{0.3, -0.7, 1.1}, {0.0, 0.0, 0.0}, {1e-200, 0.0, 2e-200}, {0.0, 20.0, 1e-9}}) {
        for (const double s : {0.0, 1e-9, 0.4, -1.3, 7.0}) {
            std::array<double, 13> given;
            for (std::size_t e = 0; e < 9; ++e) { given[e] = static_cast<double>(R[e / 3][e % 3]); }
            std::copy(L.begin(), L.end(), given.begin() + 9);
            given[12] = s;
            const WideMatrix from = matrix_of(given);
            const Wide twice = 2 * widened(s);
            const WideMatrix expected = times(
                from,
                exponential({twice * widened(L[0]), twice * widened(L[1]), twice * widened(L[2])}));
            const std::array<double, 9> changes = hvi::detail::turn_about_momentum(given);
            for (std::size_t e = 0; e < 9; ++e) {
                CAPTURE(L[1], s, e);
                const Wide change = expected[e / 3][e % 3] - from[e / 3][e % 3];
                // NOTE: the angle is rounded.
                CHECK(std::abs(widened(changes[e]) - change) <=
                      4e-16L * std::max(1.0L, std::abs(twice) * 20));
            }
        }
    }
}

TEST_CASE("a body does not grow, or shrink, where each turn is the same") {
    // NOTE: its remainders are kept, so that errors of the turn are what is left.
    const WideMatrix R = exponential({0.3L, -0.8L, 1.1L});
    std::array<double, 13> body;
    for (std::size_t e = 0; e < 9; ++e) { body[e] = static_cast<double>(R[e / 3][e % 3]); }
    body[9] = 0.3;
    body[10] = -0.7;
    body[11] = 1.1;
    body[12] = 1.3;
    std::array<double, 9> remainders{};
    const double defect = defect_of(body);
    for (int k = 0; k < 1'000'000; ++k) {
        const std::array<double, 9> changes = hvi::detail::turn_about_momentum(body);
        for (std::size_t e = 0; e < 9; ++e) {
            const auto sum = hvi::two_sum(body[e], changes[e] + remainders[e]);
            body[e] = sum.value;
            remainders[e] = sum.remainder;
        }
    }
    CHECK(defect_of(body) <= defect + 4e-13);
}

TEST_CASE("the flow of a free symmetric body is its closed form") {
    using hvi::generated::Symmetric;
    const Symmetric::Parameters of;
    Symmetric stepper(of);
    for (const double h : {0.25, -1.0, 3.0, 30.0}) {
        auto x = Symmetric::initial(of);
        const auto before = x;
        const Wide L_1 = widened(before.L[0]), L_2 = widened(before.L[1]),
                   L_3 = widened(before.L[2]);
        const Wide across = L_1 * L_1 + L_3 * L_3;
        const Wide A = widened(of.A), C = widened(of.C), k = widened(of.k), m = widened(of.m);
        // dH/dL = (s L_1, along, s L_3) = s L + u e_2.
        const Wide s = 1 / A + 4 * k * across + 2 * m * L_2;
        const Wide along = m * across + 4 * L_2 * L_2 * L_2 / C;
        const Wide u = along - s * L_2, t = widened(h);
        const WideMatrix about_axis = exponential({0, t * u, 0});
        const WideMatrix R =
            times(times(matrix_of(before.R), exponential({t * s * L_1, t * s * L_2, t * s * L_3})),
                  about_axis);
        REQUIRE(stepper.step(x, h).ok());
        CAPTURE(h);
        const Wide most = 1e-15L * (1 + 4 * std::abs(t));
        for (std::size_t e = 0; e < 9; ++e) {
            CHECK(std::abs(widened(x.R[e]) - R[e / 3][e % 3]) <= most);
        }
        // L' = L x u e_2: a row times the same matrix.
        for (std::size_t j = 0; j < 3; ++j) {
            const Wide L = L_1 * about_axis[0][j] + L_2 * about_axis[1][j] + L_3 * about_axis[2][j];
            CHECK(std::abs(widened(x.L[j]) - L) <= most);
        }
        REQUIRE(stepper.step(x, -h).ok());
        for (std::size_t e = 0; e < 9; ++e) { CHECK(std::abs(x.R[e] - before.R[e]) <= 4e-15); }
    }
}

TEST_CASE("a free symmetric body keeps momentum, energy and axes over a million steps") {
    using hvi::generated::Symmetric;
    Symmetric stepper;
    auto x = Symmetric::initial();
    const auto in_space = [&](std::size_t row) {
        return x.R[3 * row] * x.L[0] + x.R[3 * row + 1] * x.L[1] + x.R[3 * row + 2] * x.L[2];
    };
    const std::array<double, 3> J{in_space(0), in_space(1), in_space(2)};
    const double energy = stepper.energy(x), defect = defect_of(x.R);
    for (int k = 0; k < 1'000'000; ++k) { REQUIRE(stepper.step(x, 0.3).ok()); }
    CHECK(std::abs(stepper.energy(x) - energy) <= 2e-14);
    for (std::size_t row = 0; row < 3; ++row) { CHECK(std::abs(in_space(row) - J[row]) <= 1e-13); }
    CHECK(defect_of(x.R) <= defect + 4e-13);
}

TEST_CASE("a symmetric top is split in its free motion and its weight") {
    using hvi::generated::Lagrange;
    using hvi::generated::LagrangeGauss;
    const auto after = [](auto stepper, int steps) {
        auto x = decltype(stepper)::initial();
        for (int k = 0; k < steps; ++k) { REQUIRE(stepper.step(x, 4.0 / steps).ok()); }
        return x;
    };
    const auto reference = after(LagrangeGauss{}, 400);
    const auto error = [&](int steps) {
        const auto x = after(Lagrange{}, steps);
        double largest = 0;
        for (std::size_t e = 0; e < 9; ++e) {
            largest = std::max(largest, std::abs(x.R[e] - reference.R[e]));
        }
        return largest;
    };
    CHECK(std::log2(error(4) / error(8)) == Approx(8).margin(1.2));
    CHECK(error(40) < 1e-12);
}
