// Points of a report that are timed more than once.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <vector>

#include <catch2/catch.hpp>

#include "generator/study/work.hpp"

using namespace hvi::gen;

namespace {

WorkPoint timed(std::int64_t steps, double seconds, const char* status = "ok") {
    WorkPoint point;
    point.steps = steps;
    point.seconds = seconds;
    point.spread = 0.5;
    point.status = status;
    return point;
}

Measurement taking(double seconds, const char* status = "ok") {
    Measurement run;
    run.status = status;
    run.seconds = seconds;
    run.spread = 0.25;
    return run;
}

}  // namespace

TEST_CASE("of two rounds of timing the faster one counts, with its spread") {
    std::vector<WorkPoint> points{timed(10, 0.002), timed(20, 0.004)};
    time_again(points, [](const WorkPoint& point, double seconds) {
        CHECK(seconds == seconds_of_timing);
        return taking(point.steps == 10 ? 0.001 : 0.005);
    });
    CHECK(points[0].seconds == 0.001);
    CHECK(points[0].spread == 0.25);
    CHECK(points[1].seconds == 0.004);
    CHECK(points[1].spread == 0.5);
}

TEST_CASE("what failed, was not timed or takes long is not run again") {
    std::vector<WorkPoint> points{timed(1, 0, "not_converged"), timed(2, 0), timed(3, 1.0)};
    int runs = 0;
    time_again(points, [&](const WorkPoint&, double) {
        ++runs;
        return taking(1e-6);
    });
    CHECK(runs == 0);
}

TEST_CASE("a round that did not come to the end leaves what is known") {
    std::vector<WorkPoint> points{timed(1, 0.002)};
    time_again(points, [](const WorkPoint&, double) { return taking(0, "not_finite"); });
    CHECK(points[0].seconds == 0.002);
    CHECK(points[0].ok());
}
