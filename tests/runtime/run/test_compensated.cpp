// TwoSum and the condition that makes a method symplectic in doubles.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <hvi/detail/coefficients/coefficients.hpp>
#include <hvi/detail/numbers/compensated.hpp>

namespace {

long double wide(double value) { return static_cast<long double>(value); }

}  // namespace

TEST_CASE("TwoSum is exact whatever the magnitudes") {
    for (const double a : {1.0, -0.1, 1e300, 3e-300, 0.0}) {
        for (const double b : {0x1p-60, 7.7, -1e17, 5e-324, -1.0}) {
            const hvi::Sum<double> sum = hvi::two_sum(a, b);
            CHECK(sum.value == a + b);
            CHECK(wide(sum.value) + wide(sum.remainder) == wide(a) + wide(b));
        }
    }
    CHECK(hvi::two_sum(1.0, 0x1p-60).remainder == 0x1p-60);
    CHECK(hvi::two_sum(0x1p-60, 1.0).remainder == 0x1p-60);
    CHECK(hvi::detail::sums_are_exact<double>());
}

TEST_CASE("complementary coefficients add to 1 without rounding") {
    constexpr double m[1][2] = {{0.25, 1.5}};
    constexpr double right[2][1] = {{0.75}, {-0.5}};
    CHECK(hvi::detail::complementary(m, right));
    // 1 - 1/3 is not a double that adds to 1 exactly with the nearest double of 1/3.
    constexpr double third[1][1] = {{1.0 / 3}};
    constexpr double rest[1][1] = {{2.0 / 3}};
    CHECK(third[0][0] + rest[0][0] == 1.0);
    CHECK_FALSE(hvi::detail::complementary(third, rest));
}
