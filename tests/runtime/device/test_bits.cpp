// The bits of a trajectory depend on itself alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <numeric>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace device_test;

namespace {

constexpr double h = 1.0 / 16;

/// Takes all trajectories so many steps further.
template <class Stepper>
std::vector<typename Stepper::State> run(std::vector<typename Stepper::State> x, int steps) {
    const auto same = parameters<Stepper>(x.size());
    hvi::device::advance<Stepper>(x.data(), same.data(), x.size(), h, steps);
    return x;
}

/// States far from each other, of which some steps may fail.
template <class Stepper>
std::vector<typename Stepper::State> scattered(std::size_t count) {
    auto x = starts<Stepper>(count);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> by(-1.5, 1.5);
    for (auto& each : x) {
        for (std::size_t k = 0; k < each.q.size(); ++k) {
            each.q[k] += by(random);
            each.p[k] += by(random);
        }
    }
    return x;
}

}  // namespace

TEMPLATE_TEST_CASE("a thread alone and among others, in any order", "", HVI_ALL_PAIRS) {
    using Threads = typename TestType::Threads;
    const auto x = scattered<Threads>(100);
    const auto all = run<Threads>(x, 40);
    for (std::size_t i = 0; i < x.size(); i += 3) {
        CHECK(same_bits(run<Threads>({x[i]}, 40).front(), all[i]));
    }
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    std::vector<typename Threads::State> shuffled;
    for (const std::size_t i : order) { shuffled.push_back(x[i]); }
    const auto other = run<Threads>(shuffled, 40);
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(same_bits(other[i], all[order[i]])); }
}

TEMPLATE_TEST_CASE("steps in one call and in several", "", HVI_ALL_PAIRS) {
    using Threads = typename TestType::Threads;
    const auto x = scattered<Threads>(50);
    const auto at_once = run<Threads>(x, 40);
    const auto in_parts = run<Threads>(run<Threads>(run<Threads>(x, 1), 0), 39);
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(same_bits(at_once[i], in_parts[i])); }
}

TEMPLATE_TEST_CASE("a thread that fails keeps its state, and the others go on", "", HVI_ALL_PAIRS) {
    using Threads = typename TestType::Threads;
    auto x = starts<Threads>(3);
    x[1].p[0] = HUGE_VAL;
    const auto end = run<Threads>(x, 5);
    CHECK(end[1].status == hvi::Status::Code::not_finite);
    CHECK(end[1].steps == 0);
    CHECK(std::memcmp(&end[1].q, &x[1].q, sizeof x[1].q) == 0);
    CHECK(std::memcmp(&end[1].p, &x[1].p, sizeof x[1].p) == 0);
    CHECK(end[0].steps == 5);
    CHECK(end[2].steps == 5);

    const typename Threads::Steps too_large(HUGE_VAL), none(0);
    const Threads stepper{typename Threads::Parameters()};
    auto y = x[0];
    stepper.step(y, none);
    CHECK(same_bits(y, x[0]));
    stepper.step(y, too_large);
    CHECK(y.status != hvi::Status::Code::ok);
    CHECK(y.steps == 0);
}

TEMPLATE_TEST_CASE("trajectories that go on, from a list of them", "", HVI_ALL_PAIRS) {
    using Threads = typename TestType::Threads;
    auto x = scattered<Threads>(20);
    for (std::size_t i = 0; i < x.size(); i += 3) { x[i].p[0] = HUGE_VAL; }
    const auto at_once = run<Threads>(x, 30);
    const auto same = parameters<Threads>(x.size());
    std::vector<std::uint32_t> which(x.size());
    for (int part = 0; part < 3; ++part) {
        const std::size_t going = hvi::device::list_going(x.data(), x.size(), which.data());
        CHECK((part == 0 ? going == x.size() : going <= x.size() - 7));
        hvi::device::advance_listed<Threads>(x.data(), same.data(), which.data(), going, h, 10);
    }
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(same_bits(x[i], at_once[i])); }
}

TEST_CASE("parameters belong to a trajectory") {
    using Kepler = made::KahanLiKeplerThreads;
    std::vector<Kepler::Parameters> suns(4);
    std::vector<Kepler::State> x;
    for (std::size_t i = 0; i < suns.size(); ++i) {
        suns[i].mu = 1 + static_cast<double>(i) / 4;
        x.push_back(Kepler::initial(suns[i]));
    }
    auto all = x;
    hvi::device::advance<Kepler>(all.data(), suns.data(), all.size(), h, 100);
    for (std::size_t i = 0; i < suns.size(); ++i) {
        hvi::device::advance<Kepler>(&x[i], &suns[i], 1, h, 100);
        CHECK(same_bits(x[i], all[i]));
        // Orbits around another mass are the same, in another time: p grows as sqrt(mu).
        CHECK((i == 0) == same_bits(x[i], x[0]));
    }
}
