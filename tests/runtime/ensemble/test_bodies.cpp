// Bodies that turn, of trajectories side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <ensemble/one/split_body.hpp>
#include <ensemble/one/split_charged.hpp>
#include <ensemble/one/split_lagrange.hpp>
#include <ensemble/one/split_top.hpp>
#include <ensemble/split_body.hpp>
#include <ensemble/split_charged.hpp>
#include <ensemble/split_lagrange.hpp>
#include <ensemble/split_symmetric.hpp>
#include <ensemble/split_top.hpp>
#include <hvi/detail/lanes/lane_turns.hpp>
#include <hvi/ensemble.hpp>

#include "tests/runtime/flows/turns_by_series.hpp"

using namespace flow_test;

namespace {

namespace made = hvi::generated;

template <class EnsembleStepper, class OneStepper>
struct Pair {
    using Many = EnsembleStepper;
    using One = OneStepper;
};
using Body = Pair<made::SplitBodies, made::SplitBody>;
using Top = Pair<made::SplitTops, made::SplitTop>;
using Lagrange = Pair<made::SplitLagranges, made::SplitLagrange>;
using Charged = Pair<made::SplitChargeds, made::SplitCharged>;

constexpr std::size_t at_once = hvi::trajectories_at_once;

/// Returns bodies where the scene begins, with momenta moved by up to `most`, some of them at rest.
template <class Many>
std::vector<typename Many::Trajectory> bodies(std::size_t count, double most) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> by(-most, most);
    std::vector<typename Many::Trajectory> result(count, Many::initial());
    for (std::size_t i = 0; i < count; ++i) {
        for (double& L : result[i].L) { L = i % 7 == 4 ? 0 : L + by(random); }
    }
    return result;
}

/// Returns the numbers of a state in a row.
template <class Stepper, class State>
std::vector<double> numbers(const State& x) {
    const auto at = Stepper::flat(x);
    std::vector<double> result(at.q.begin(), at.q.end());
    result.insert(result.end(), at.p.begin(), at.p.end());
    return result;
}

template <class State>
bool same_bits(const State& x, const State& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
}

/// Returns a trajectory after steps that it takes alone.
template <class One>
std::vector<double> alone(const std::vector<double>& start, double h, int steps) {
    hvi::detail::ChartState<typename One::Space> at;
    std::copy_n(start.begin(), at.q.size(), at.q.begin());
    std::copy_n(start.end() - static_cast<std::ptrdiff_t>(at.p.size()), at.p.size(), at.p.begin());
    typename One::State x;
    One::set(x, at);
    One stepper;
    for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(x, h).ok()); }
    return numbers<One>(x);
}

/// Returns the angular momentum in space.
template <class State>
std::array<double, 3> in_space(const State& x) {
    std::array<double, 3> J{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) { J[i] += x.R[3 * i + k] * x.L[k]; }
    }
    return J;
}

}  // namespace

// ---- functions of lanes ----

TEST_CASE("lanes turn about their momenta by exponentials, at rest as well") {
    using Lane = hvi::Lanes<double, at_once>;
    const std::array<std::array<double, 3>, at_once> L{{{0.3, -0.7, 1.1},
                                                        {0, 0, 0},
                                                        {1e-200, 0, 2e-200},
                                                        {0, 20, 1e-9},
                                                        {-1e-5, 1e-5, 0},
                                                        {2, 3, -4},
                                                        {0, 0, 1},
                                                        {1e-3, 0, 0}}};
    const std::array<double, at_once> s{0.4, 7, -1.3, 0.25, 1e3, -0.5, 0, 1e-9};
    const WideMatrix R = exponential({0.3L, -0.8L, 1.1L});
    std::array<Lane, 13> given;
    std::array<std::array<double, at_once>, 13> rows{};
    for (std::size_t lane = 0; lane < at_once; ++lane) {
        for (std::size_t e = 0; e < 9; ++e) {
            rows[e][lane] = static_cast<double>(R[e / 3][e % 3]);
        }
        for (std::size_t k = 0; k < 3; ++k) { rows[9 + k][lane] = L[lane][k]; }
        rows[12][lane] = s[lane];
    }
    for (std::size_t k = 0; k < 13; ++k) { given[k] = Lane::load(rows[k].data()); }
    const std::array<Lane, 9> changes = hvi::detail::turn_about_momentum(given);
    for (std::size_t e = 0; e < 9; ++e) {
        std::array<double, at_once> change{};
        changes[e].store(change.data());
        for (std::size_t lane = 0; lane < at_once; ++lane) {
            WideMatrix from;
            for (std::size_t k = 0; k < 9; ++k) { from[k / 3][k % 3] = widened(rows[k][lane]); }
            WideVector angle;
            Wide size = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                angle[k] = 2 * widened(s[lane]) * widened(L[lane][k]);
                size += std::abs(angle[k]);
            }
            const WideMatrix to = times(from, exponential(angle));
            CAPTURE(lane, e);
            CHECK(std::abs(widened(change[lane]) - (to[e / 3][e % 3] - from[e / 3][e % 3])) <=
                  4e-16L * std::max(1.0L, size));
        }
    }
}

TEST_CASE("shears of small turns are those of long double, in each lane") {
    for (int i = -512; i < 512; i += 8) {
        std::array<double, at_once> y{}, tangents{}, sines{};
        for (std::size_t lane = 0; lane < at_once; ++lane) {
            y[lane] = (i + static_cast<double>(lane) + 0.5) / 1024;
        }
        const auto lanes = hvi::Lanes<double, at_once>::load(y.data());
        hvi::math::small_tan(lanes).store(tangents.data());
        hvi::math::small_double_sin(lanes).store(sines.data());
        for (std::size_t lane = 0; lane < at_once; ++lane) {
            const Wide tangent = std::tan(widened(y[lane])), sine = std::sin(2 * widened(y[lane]));
            CAPTURE(y[lane]);
            CHECK(std::abs(widened(tangents[lane]) - tangent) <= 0x1p-52L * std::abs(tangent));
            CHECK(std::abs(widened(sines[lane]) - sine) <= 0x1p-52L * std::abs(sine));
        }
    }
}

// ---- flows that are known in closed form ----

TEST_CASE(
    "free symmetric bodies, each with its moments and its step, turn as the closed form says") {
    using Many = made::SplitSymmetrics;
    constexpr std::size_t count = 21;
    std::vector<Many::Parameters> own(count);
    std::vector<double> h;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(i);
        own[i].A = 1 + number / 8;
        own[i].C = 4 - number / 8;
        own[i].k = 0.1 + number / 50;
        own[i].m = i % 4 == 1 ? 0 : number / 70;
        h.push_back((i % 2 == 0 ? 1 : -1) * (i % 5 == 2 ? 30 : number / 16));
    }
    const std::vector<Many::Trajectory> starts = bodies<Many>(count, 0.5);
    hvi::Ensemble<Many> ensemble(starts, own);
    ensemble.advance(h, std::vector<std::int64_t>(count, 1));
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < count; ++i) {
        const Many::Trajectory& x = starts[i];
        const Wide L_1 = widened(x.L[0]), L_2 = widened(x.L[1]), L_3 = widened(x.L[2]);
        const Wide across = L_1 * L_1 + L_3 * L_3, t = widened(h[i]);
        const Wide A = widened(own[i].A), C = widened(own[i].C), k = widened(own[i].k),
                   m = widened(own[i].m);
        // dH/dL = (s L_1, along, s L_3) = s L + u e_2.
        const Wide s = 1 / A + 4 * k * across + 2 * m * L_2;
        const Wide u = m * across + 4 * L_2 * L_2 * L_2 / C - s * L_2;
        const WideMatrix about_axis = exponential({0, t * u, 0});
        const WideMatrix R =
            times(times(matrix_of(x.R), exponential({t * s * L_1, t * s * L_2, t * s * L_3})),
                  about_axis);
        const Many::Trajectory end = ensemble.state(i);
        const Wide most = 1e-15L * (2 + std::abs(t) * 8);
        CAPTURE(i, h[i]);
        for (std::size_t e = 0; e < 9; ++e) {
            CHECK(std::abs(widened(end.R[e]) - R[e / 3][e % 3]) <= most);
        }
        for (std::size_t j = 0; j < 3; ++j) {
            const Wide L = L_1 * about_axis[0][j] + L_2 * about_axis[1][j] + L_3 * about_axis[2][j];
            CHECK(std::abs(widened(end.L[j]) - L) <= most);
        }
    }
}

TEST_CASE("free bodies keep their momenta in space, and their axes") {
    using Many = made::SplitBodies;
    const std::vector<Many::Trajectory> starts = bodies<Many>(13, 2);
    hvi::Ensemble<Many> ensemble(starts);
    ensemble.advance(0.25, 100'000);
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const auto J = in_space(starts[i]), end = in_space(ensemble.state(i));
        CAPTURE(i);
        for (std::size_t k = 0; k < 3; ++k) { CHECK(std::abs(end[k] - J[k]) <= 4e-13); }
        CHECK(defect_of(ensemble.state(i).R) <= 4e-13);
    }
}

TEST_CASE("the energy of heavy tops errs by h^2, and the momentum about the vertical stays") {
    using Many = made::SplitTops;
    std::vector<Many::Parameters> own(11);
    for (std::size_t i = 0; i < own.size(); ++i) {
        own[i].g = 0.5 + static_cast<double>(i) / 16;
        own[i].inertia[0] = 1 + static_cast<double>(i) / 32;
    }
    const std::vector<Many::Trajectory> starts = bodies<Many>(own.size(), 0.3);
    const auto errors = [&](double h, std::int64_t steps) {
        std::vector<double> result(starts.size());
        hvi::Ensemble<Many> ensemble(starts, own);
        ensemble.advance_watched(h, steps, [&](std::size_t i, const Many::Trajectory& now) {
            const Many stepper(own[i]);
            const double error = stepper.energy(now) - stepper.energy(starts[i]);
            result[i] = std::max(result[i], std::abs(error));
            return true;
        });
        REQUIRE(ensemble.ok());
        for (std::size_t i = 0; i < starts.size(); ++i) {
            CHECK(std::abs(in_space(ensemble.state(i))[2] - in_space(starts[i])[2]) <= 4e-14);
        }
        return result;
    };
    const std::vector<double> large = errors(1.0 / 32, 100), small = errors(1.0 / 64, 200);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(large[i] / small[i] - 4) < 0.1);
    }
}

// ---- lanes ----

#if defined(__x86_64__) && !defined(__FMA__)
TEMPLATE_TEST_CASE("where no product is fused with a sum, small turns have the bits of one body",
                   "", Body, Top, Charged) {
    using Many = typename TestType::Many;
    using One = typename TestType::One;
    const auto starts = bodies<Many>(19, 0.5);
    hvi::Ensemble<Many> ensemble(starts);
    ensemble.advance(1.0 / 16, 200);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        CHECK(numbers<Many>(ensemble.state(i)) ==
              alone<One>(numbers<Many>(starts[i]), 1.0 / 16, 200));
    }
}
#endif

TEMPLATE_TEST_CASE("turns of any size are those of one body, up to rounding", "", Body, Top,
                   Lagrange, Charged) {
    using Many = typename TestType::Many;
    using One = typename TestType::One;
    const auto starts = bodies<Many>(19, 4);
    hvi::Ensemble<Many> ensemble(starts);
    ensemble.advance(1.0 / 2, 8);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const auto together = numbers<Many>(ensemble.state(i)),
                   expected = alone<One>(numbers<Many>(starts[i]), 1.0 / 2, 8);
        CAPTURE(i);
        for (std::size_t k = 0; k < expected.size(); ++k) {
            CHECK(std::abs(together[k] - expected[k]) <= 1e-12);
        }
    }
}

TEMPLATE_TEST_CASE("bits of a body do not depend on how its neighbours turn", "", Body, Top,
                   Lagrange, Charged) {
    using Many = typename TestType::Many;
    const auto end_of = [](const std::vector<typename Many::Trajectory>& x) {
        hvi::Ensemble<Many> ensemble(x);
        ensemble.advance(1.0 / 8, 30);
        return ensemble;
    };
    // NOTE: of some all turns are small, of some they are large, and of others now and then.
    std::vector<typename Many::Trajectory> x;
    for (const double most : {0.2, 4.0, 40.0}) {
        const auto more = bodies<Many>(17, most);
        x.insert(x.end(), more.begin(), more.end());
    }
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    std::vector<typename Many::Trajectory> shuffled;
    for (const std::size_t i : order) { shuffled.push_back(x[i]); }
    const auto all = end_of(x), other = end_of(shuffled);
    for (std::size_t i = 0; i < x.size(); ++i) {
        CAPTURE(i);
        CHECK(same_bits(other.state(i), all.state(order[i])));
        CHECK(same_bits(end_of({x[i]}).state(0), all.state(i)));
    }
}

TEMPLATE_TEST_CASE("a body that is no number stops, and the others go on", "", Body, Top, Lagrange,
                   Charged) {
    using Many = typename TestType::Many;
    auto x = bodies<Many>(17, 0.5);
    x[5].L[1] = std::numeric_limits<double>::quiet_NaN();
    x[11].R[4] = std::numeric_limits<double>::infinity();
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(1.0 / 16, 40);
    for (std::size_t i = 0; i < x.size(); ++i) {
        CAPTURE(i);
        if (i == 5 || i == 11) {
            CHECK(ensemble.status(i).code() == hvi::Status::Code::not_finite);
            CHECK(ensemble.steps(i) == 0);
            CHECK(same_bits(ensemble.state(i), x[i]));
            continue;
        }
        hvi::Ensemble<Many> alone({x[i]});
        alone.advance(1.0 / 16, 40);
        CHECK(ensemble.status(i).ok());
        CHECK(ensemble.steps(i) == 40);
        CHECK(same_bits(ensemble.state(i), alone.state(0)));
    }
}

TEST_CASE("energies of eight bodies are those of each") {
    using Many = made::SplitTops;
    const auto x = bodies<Many>(at_once, 1);
    const Many stepper;
    Many::State state;
    for (std::size_t lane = 0; lane < at_once; ++lane) { state.set(lane, x[lane]); }
    std::array<double, at_once> energies{};
    stepper.energy(state).store(energies.data());
    for (std::size_t lane = 0; lane < at_once; ++lane) {
        CHECK(same_bits(state[lane], x[lane]));
        CHECK(energies[lane] == Approx(stepper.energy(x[lane])).epsilon(1e-15));
    }
}
