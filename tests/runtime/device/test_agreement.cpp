// Threads against steppers of one trajectory. NOTE: products and sums are compiled as written.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace device_test;

namespace {

constexpr double h = 1.0 / 64;

/// Returns the largest distance of threads from trajectories, after so many steps.
template <class Pair>
double worst_after(int steps) {
    using Threads = typename Pair::Threads;
    auto x = starts<Threads>(20);
    auto ends = x;
    const auto same = parameters<Threads>(x.size());
    hvi::device::advance<Threads>(ends.data(), same.data(), ends.size(), h, steps);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        typename Pair::One stepper;
        auto y = alone<typename Pair::One>(x[i]);
        for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(y, h).ok()); }
        CHECK(ends[i].steps == steps);
        worst = std::fmax(worst, distance(ends[i], y));
    }
    return worst;
}

}  // namespace

TEMPLATE_TEST_CASE("without functions a thread has the bits of a trajectory", "",
                   HVI_PAIRS_WITHOUT_FUNCTIONS) {
    CHECK(worst_after<TestType>(1) == 0);
    CHECK(worst_after<TestType>(1000) == 0);
}

/// NOTE: functions of both differ by 3 units in the last place or fewer, and h times that is added
/// in each move.
TEMPLATE_TEST_CASE("with functions a thread is near a trajectory", "", HVI_PAIRS_WITH_FUNCTIONS) {
    CHECK(worst_after<TestType>(1) <= 2);
    CHECK(worst_after<TestType>(1000) <= 1e4);
}

TEST_CASE("energies and invariants are those of a trajectory") {
    using Threads = made::VerletKeplerThreads;
    const Threads threads{Threads::Parameters()};
    made::VerletKeplerAlone one;
    for (const auto& x : starts<Threads>(10)) {
        const auto y = alone<made::VerletKeplerAlone>(x);
        CHECK(threads.energy(x) == one.energy(y));
        CHECK(threads.angular_momentum(x) == one.angular_momentum(y));
    }
}

TEST_CASE("float steps follow steps in double") {
    using Single = made::BasicKahanLiKeplerThreads<float>;
    using Double = made::KahanLiKeplerThreads;
    const Single::Parameters single;
    const Double::Parameters twice;
    auto x = Single::initial(single);
    auto y = Double::initial(twice);
    hvi::device::advance<Single>(&x, &single, 1, 0.125f, 1000);
    hvi::device::advance<Double>(&y, &twice, 1, 0.125, 1000);
    REQUIRE(x.steps == 1000);
    // Compensated sums: after twenty orbits the error is one of a few roundings of the orbit.
    CHECK(std::abs(double(x.q[0]) - y.q[0]) < 1e-3);
    CHECK(std::abs(double(x.p[0]) - y.p[0]) < 1e-3);
}
