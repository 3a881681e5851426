// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/support/pace.hpp"

using namespace hvi::gen;
using namespace std::chrono_literals;

TEST_CASE("a pace is told from the second word on") {
    const auto start = Pace::Clock::now();
    Pace pace(1e6, "steps");
    CHECK(pace.at(0.1, start).empty());
    CHECK(pace.at(0.1, start + 1s).empty());
    CHECK(pace.at(0.2, start).empty());
    CHECK(pace.at(0.2, start + 2s) == "5e+04 steps/s, 16 s left");
    CHECK(pace.at(0.6, start + 1000s) == "500 steps/s, 13 min left");
    CHECK(pace.at(0.2, start + 2000s) == "50 steps/s, 4.4 h left");
    CHECK(pace.at(1, start + 9s) == "1e+05 steps/s, 0 s left");
}
