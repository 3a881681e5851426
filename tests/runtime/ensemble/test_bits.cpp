// The bits of a trajectory depend on itself alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <numeric>

#include <catch2/catch.hpp>
// NOTE: before the headers of steppers: its names are not to hide those that they mean.
#include <hvi/ensemble.hpp>

#include "steppers.hpp"

using namespace ensemble_test;

namespace {

constexpr double h = 1.0 / 16;
constexpr int steps = 50;

template <class Many>
hvi::Ensemble<Many> run(const std::vector<typename Many::Trajectory>& x, unsigned threads) {
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(h, steps, threads);
    return ensemble;
}

/// Whether trajectory i of `a` equals trajectory j of `b`.
template <class Ensemble>
bool same(const Ensemble& a, std::size_t i, const Ensemble& b, std::size_t j) {
    return same_bits(a.state(i), b.state(j)) && a.status(i).code() == b.status(j).code() &&
           a.status(i).iterations == b.status(j).iterations && a.steps(i) == b.steps(j);
}

/// States that iterate unequally often and fail here and there: up to `scale` times the scene's.
template <class Many>
std::vector<typename Many::Trajectory> scattered(std::size_t count) {
    auto x = starts<Many>(count);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> by(-1.5, 1.5);
    for (auto& each : x) {
        for (std::size_t k = 0; k < dimension<Many>; ++k) {
            each.q[k] += by(random);
            each.p[k] += by(random);
        }
    }
    return x;
}

}  // namespace

TEMPLATE_TEST_CASE("alone and among others, in any order", "", HVI_EXPLICIT_PAIRS,
                   HVI_IMPLICIT_PAIRS) {
    using Many = typename TestType::Many;
    const auto x = scattered<Many>(200);
    const auto all = run<Many>(x, 1);

    for (std::size_t i = 0; i < x.size(); i += 3) {
        const auto alone = run<Many>({x[i]}, 1);
        CHECK(same(all, i, alone, 0));
    }

    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    std::vector<typename Many::Trajectory> shuffled;
    for (const std::size_t i : order) { shuffled.push_back(x[i]); }
    const auto other = run<Many>(shuffled, 1);
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(same(other, i, all, order[i])); }
}

TEMPLATE_TEST_CASE("on any number of threads, of any number of trajectories", "",
                   HVI_EXPLICIT_PAIRS, HVI_IMPLICIT_PAIRS) {
    using Many = typename TestType::Many;
    const auto x = scattered<Many>(1000);
    const auto all = run<Many>(x, 1);
    for (const std::size_t size :
         {std::size_t{1}, std::size_t{7}, std::size_t{8}, std::size_t{9}, std::size_t{1000}}) {
        const std::vector<typename Many::Trajectory> some(
            x.begin(), x.begin() + static_cast<std::ptrdiff_t>(size));
        for (const unsigned threads : {0U, 1U, 2U, 3U}) {
            const auto ensemble = run<Many>(some, threads);
            REQUIRE(ensemble.size() == size);
            bool all_same = true;
            for (std::size_t i = 0; i < size; ++i) { all_same &= same(ensemble, i, all, i); }
            CHECK(all_same);
        }
    }
}

TEST_CASE("of none") {
    hvi::Ensemble<made::Gauss4Keplers> ensemble({});
    ensemble.advance(0.1, 10);
    CHECK(ensemble.size() == 0);
    CHECK(ensemble.ok());
}

TEST_CASE("a lane that is set anew, and a state that is changed, are those of a fresh stepper") {
    using Many = made::Gauss4Keplers;
    const auto x = starts<Many>(8);
    Many used, fresh;
    Many::State state;
    for (std::size_t i = 0; i < 8; ++i) { state.set(i, x[i]); }
    for (int step = 0; step < 5; ++step) { REQUIRE(used.step(state, h).ok()); }
    for (std::size_t i = 0; i < 8; ++i) { state.set(i, x[7 - i]); }
    Many::State other;
    for (std::size_t i = 0; i < 8; ++i) { other.set(i, x[7 - i]); }
    for (int step = 0; step < 5; ++step) {
        REQUIRE(used.step(state, h).ok());
        REQUIRE(fresh.step(other, h).ok());
    }
    for (std::size_t i = 0; i < 8; ++i) { CHECK(same_bits(state[i], other[i])); }
}
