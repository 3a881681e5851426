// Trajectories that stop, and others that go on.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <limits>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace ensemble_test;
using Code = hvi::Status::Code;

namespace {

/// All of them as if those that stop were not there.
template <class Many>
void check_others(const hvi::Ensemble<Many>& ensemble,
                  const std::vector<typename Many::Trajectory>& x, double h, int steps,
                  std::size_t stopped) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i == stopped) { continue; }
        hvi::Ensemble<Many> alone({x[i]});
        alone.advance(h, steps, 1);
        CHECK(ensemble.status(i).ok());
        CHECK(ensemble.steps(i) == steps);
        CHECK(same_bits(ensemble.state(i), alone.state(0)));
    }
}

}  // namespace

TEMPLATE_TEST_CASE("one that is no number", "", HVI_EXPLICIT_PAIRS, HVI_IMPLICIT_PAIRS) {
    using Many = typename TestType::Many;
    auto x = starts<Many>(17);
    x[5].q[0] = std::numeric_limits<double>::quiet_NaN();
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(1.0 / 32, 40);
    CHECK_FALSE(ensemble.ok());
    CHECK(ensemble.status(5).code() == Code::not_finite);
    CHECK(ensemble.steps(5) == 0);
    CHECK(same_bits(ensemble.state(5), x[5]));
    check_others(ensemble, x, 1.0 / 32, 40, 5);
}

TEMPLATE_TEST_CASE("one that falls into the sun", "", VerletKepler, Gauss4Kepler) {
    using Many = typename TestType::Many;
    constexpr double h = 1.0 / 32;
    constexpr int steps = 60;
    auto x = starts<Many>(17);
    x[9] = {{1.0, 0.0}, {0.0, 0.0}};  // falls in the time pi/sqrt(8)
    if (std::is_same_v<TestType, VerletKepler>) { x[9] = {{0.0, 0.0}, {0.0, 0.0}}; }
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(h, steps);
    CHECK_FALSE(ensemble.status(9).ok());

    typename TestType::One stepper;
    auto y = x[9];
    std::int64_t taken = 0;
    while (taken < steps && stepper.step(y, h).ok()) { ++taken; }
    CHECK(ensemble.steps(9) < steps);
    if (std::is_same_v<TestType, VerletKepler>) { CHECK(ensemble.steps(9) == taken); }
    check_others(ensemble, x, h, steps, 9);

    // The trajectory stays where it stopped.
    const auto at = ensemble.state(9);
    const std::int64_t steps_before = ensemble.steps(9);
    const Code code = ensemble.status(9).code();
    ensemble.advance(h, steps);
    CHECK(same_bits(ensemble.state(9), at));
    CHECK(ensemble.steps(9) == steps_before);
    CHECK(ensemble.status(9).code() == code);
    CHECK(ensemble.steps(8) == 2 * steps);
}

TEST_CASE("one whose stages do not converge, after some steps") {
    using Many = made::Gauss8HenonHeileses;
    constexpr double h = 0.5;
    auto x = starts<Many>(8);
    x[3] = {{0.2, 0.9}, {0.1, 1.5}};  // above the saddle: it leaves, ever faster
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(h, 60);
    CHECK(ensemble.status(3).code() == Code::not_converged);
    CHECK(ensemble.steps(3) > 0);
    CHECK(ensemble.steps(3) < 60);
    check_others(ensemble, x, h, 60, 3);

    // The state of before the step: a fresh one takes as many steps to it, bit for bit.
    hvi::Ensemble<Many> alone({x[3]});
    alone.advance(h, ensemble.steps(3));
    CHECK(alone.ok());
    CHECK(same_bits(alone.state(0), ensemble.state(3)));
}

TEMPLATE_TEST_CASE("all, at a step that is too large or no number", "", MidpointPendulum,
                   Gauss3Nonseparable, Gauss8HenonHeiles) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(9);
    for (const double h :
         {1e3, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        hvi::Ensemble<Many> ensemble(x);
        ensemble.advance(h, 3);
        for (std::size_t i = 0; i < x.size(); ++i) {
            CHECK_FALSE(ensemble.status(i).ok());
            CHECK(ensemble.steps(i) == 0);
            CHECK(same_bits(ensemble.state(i), x[i]));
        }
    }
}
