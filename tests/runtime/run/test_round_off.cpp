// The stop at round-off.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <functional>
#include <limits>

#include <catch2/catch.hpp>
#include <hvi/detail/solvers/round_off.hpp>

#include "systems.hpp"

namespace {

using hvi::detail::Verdict;

struct Sizes {
    double q = 1.0;
    [[nodiscard]] double size_q(std::size_t) const { return q; }
    [[nodiscard]] double size_p(std::size_t) const { return 1.0; }
};

/// Feeds changes until a verdict other than to go on; -1 when none comes in 200 sweeps.
int sweeps_until(Verdict wanted, const std::function<double(int)>& change, Sizes sizes = {}) {
    hvi::detail::RoundOff<systems::One> round_off(8 * 0x1p-52);
    round_off.begin(1);
    for (int i = 0; i < 200; ++i) {
        const hvi::State<systems::One> changes{{change(i)}, {0.0}};
        const Verdict verdict = round_off.judge<true, false>(changes, sizes);
        if (verdict == wanted) { return i; }
        if (verdict != Verdict::go_on) { return -2; }
    }
    return -1;
}

}  // namespace

TEST_CASE("an iteration ends when nothing changes") {
    CHECK(sweeps_until(Verdict::unchanged,
                       [](int i) { return i < 5 ? std::exp2(-10 * i) : 0.0; }) == 5);
}

TEST_CASE("an iteration ends one sweep after the noise has stopped falling") {
    const auto change = [](int i) { return i < 5 ? std::exp2(-10 * i) : 0x1p-52; };
    CHECK(sweeps_until(Verdict::at_noise, change) == 7);
}

TEST_CASE("an iteration that diverges is never taken for converged") {
    CHECK(sweeps_until(Verdict::at_noise, [](int i) { return std::pow(1.01, i); }) == -1);
    CHECK(sweeps_until(Verdict::at_noise, [](int i) { return 1e-6 * std::pow(1.01, i); }) == -1);
    CHECK(sweeps_until(Verdict::not_finite, [](int i) { return std::pow(1e30, i); }) == 11);
}

TEST_CASE("an iteration that circles while it converges goes on") {
    // |0.8^i cos(i)| is not monotone; it falls to 1e-15 after about 150 sweeps.
    const auto change = [](int i) { return std::abs(std::pow(0.8, i) * std::cos(i)); };
    CHECK(sweeps_until(Verdict::at_noise, change) > 100);
}

TEST_CASE("noise of a gradient with cancellation ends an iteration, later") {
    const auto change = [](int i) { return i < 4 ? std::exp2(-12 * i) : 0x1p-43; };
    const int sweeps = sweeps_until(Verdict::at_noise, change);
    CHECK(sweeps > 12);
    CHECK(sweeps < 20);
}

TEST_CASE("what is not a number ends an iteration") {
    const auto change = [](int i) {
        return i < 3 ? 1.0 : std::numeric_limits<double>::quiet_NaN();
    };
    CHECK(sweeps_until(Verdict::not_finite, change) == 3);
}
