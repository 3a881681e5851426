// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/support/ticks.hpp"

using namespace hvi::gen;

TEST_CASE("ticks stand at 1, 2 or 5 times a power of ten, and are not too many") {
    CHECK(distance_of_ticks(17.05, 6) == 5);
    CHECK(distance_of_ticks(34.1, 6) == 10);
    CHECK(distance_of_ticks(6, 6) == 1);
    CHECK(distance_of_ticks(6.1, 6) == 2);
    CHECK(distance_of_ticks(200, 6) == 50);
    CHECK(distance_of_ticks(0.3, 6) == Approx(0.05));
    CHECK(distance_of_ticks(1e300, 6) == Approx(2e299));
    CHECK(distance_of_ticks(1e-300, 6) == Approx(2e-301));
    CHECK(distance_of_ticks(20, 10.5) == 2);
}
