// Flows of parts of H, of trajectories side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>

#include <catch2/catch.hpp>
#include <ensemble/split_disturbed.hpp>
#include <ensemble/split_oscillator.hpp>
#include <ensemble/split_penning.hpp>

#include "steppers.hpp"

using namespace ensemble_test;

namespace {

using Real = long double;

Real wide(double number) { return static_cast<Real>(number); }

/// Returns starts of Henon and Heiles below the saddles, so that all stay.
std::vector<made::SplitHenonHeileses::Trajectory> bound_stars(std::size_t count) {
    auto result = starts<made::SplitHenonHeileses>(count);
    for (auto& x : result) {
        for (auto& p : x.p) { p /= 2; }
    }
    return result;
}

/// Returns the largest error of the energy of each trajectory on its way.
template <class Many>
std::vector<double> energy_errors(const std::vector<typename Many::Trajectory>& x,
                                  const std::vector<typename Many::Parameters>& parameters,
                                  double h, std::int64_t steps) {
    std::vector<double> errors(x.size());
    hvi::Ensemble<Many> ensemble(x, parameters);
    ensemble.advance_watched(h, steps, [&](std::size_t i, const typename Many::Trajectory& now) {
        const Many stepper(parameters[i]);
        errors[i] = std::max(errors[i], std::abs(stepper.energy(now) - stepper.energy(x[i])));
        return true;
    });
    REQUIRE(ensemble.ok());
    return errors;
}

}  // namespace

// ---- flows that are known in closed form ----

TEST_CASE("oscillators of any stiffness, each with its steps, swing as the closed form says") {
    using Many = made::SplitOscillators;  // H = (a q^2 + b p^2)/2
    constexpr std::size_t count = 21;
    std::vector<Many::Parameters> own(count);
    std::vector<double> h;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(i);
        own[i].a = i % 7 == 3 ? 0 : 0.25 * (number - 5);  // springs that push, too
        own[i].b = i % 7 == 5 ? 0 : 0.5 + 0.125 * number;
        h.push_back((i % 2 == 0 ? 1 : -1) * (1 + 0.25 * number) / 64);
    }
    std::vector<Many::Trajectory> x = starts<Many>(count);
    hvi::Ensemble<Many> ensemble(x, own);
    ensemble.advance(h, std::vector<std::int64_t>(count, 100));
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < count; ++i) {
        const Real a = wide(own[i].a), b = wide(own[i].b), t = 100 * wide(h[i]);
        const Real q = wide(x[i].q[0]), p = wide(x[i].p[0]);
        const std::complex<Real> w = std::sqrt(std::complex<Real>(a * b));
        const Real cosine = std::cos(w * t).real();
        const Real sine = a * b == 0 ? t : (std::sin(w * t) / w).real();
        const Real size = std::abs(cosine) + std::abs(sine) * (1 + std::abs(a) + std::abs(b));
        CAPTURE(i, own[i].a, own[i].b, h[i]);
        CHECK(std::abs(wide(ensemble.state(i).q[0]) - (cosine * q + b * sine * p)) <=
              2e-14L * size);
        CHECK(std::abs(wide(ensemble.state(i).p[0]) - (cosine * p - a * sine * q)) <=
              2e-14L * size);
    }
}

TEST_CASE("charges in magnetic fields of their own turn as the closed form says") {
    using Many = made::SplitPennings;
    using Complex = std::complex<Real>;
    constexpr std::size_t count = 13;
    std::vector<Many::Parameters> own(count);
    std::vector<double> h;
    for (std::size_t i = 0; i < count; ++i) {
        own[i].m = 1 + static_cast<double>(i % 3);
        own[i].b = static_cast<double>(i) - 4.5;
        h.push_back(0.25 + static_cast<double>(i) / 8);
    }
    std::vector<Many::Trajectory> x = starts<Many>(count);
    hvi::Ensemble<Many> ensemble(x, own);
    ensemble.advance(h, std::vector<std::int64_t>(count, 64));
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < count; ++i) {
        // u = x + i y: m u'' = -i b u', and z and its momentum are free.
        const Real m = wide(own[i].m), b = wide(own[i].b), t = 64 * wide(h[i]);
        const Complex u(wide(x[i].q[0]), wide(x[i].q[1]));
        const Complex v((wide(x[i].p[0]) + b * u.imag() / 2) / m,
                        (wide(x[i].p[1]) - b * u.real() / 2) / m);
        const Complex turn = std::exp(Complex(0, -b * t / m));
        const Complex expected = u + v * (turn - Real(1)) / Complex(0, -b / m);
        const auto end = ensemble.state(i);
        const Real size = std::abs(u) + 2 * m / std::abs(b) * std::abs(v);
        CAPTURE(i, own[i].m, own[i].b, h[i]);
        CHECK(std::abs(Complex(wide(end.q[0]), wide(end.q[1])) - expected) <= 4e-15L * size);
        CHECK(std::abs(wide(end.q[2]) - (wide(x[i].q[2]) + t * wide(x[i].p[2]) / m)) <= 4e-14L);
        CHECK(end.p[2] == x[i].p[2]);
    }
}

TEST_CASE("the energies of matrices have no drift") {
    using Many = made::SplitPennings;
    std::vector<Many::Parameters> own(9);
    for (std::size_t i = 0; i < own.size(); ++i) {
        own[i].b = 1.5 + static_cast<double>(i) / 8;
        own[i].k = 0.25;
    }
    const std::vector<Many::Trajectory> x = starts<Many>(own.size());
    hvi::Ensemble<Many> ensemble(x, own);
    ensemble.advance(0.3, 200'000);
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < own.size(); ++i) {
        // Rounded sums would drift by 6e-18 a step, 1.2e-12; see docs/inside/scenes.md.
        const double before = ensemble.stepper(i).energy(x[i]);
        CHECK(std::abs(ensemble.stepper(i).energy(ensemble.state(i)) - before) <=
              2e-13 * std::max(1.0, std::abs(before)));
    }
}

// ---- orders ----

TEST_CASE("the energy of strang errs by h^2") {
    using Many = made::SplitHenonHeileses;
    const std::vector<Many::Trajectory> x = bound_stars(11);
    const std::vector<Many::Parameters> same(x.size());
    const std::vector<double> large = energy_errors<Many>(x, same, 1.0 / 8, 400),
                              small = energy_errors<Many>(x, same, 1.0 / 16, 800);
    for (std::size_t i = 0; i < x.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(large[i] / small[i] - 4) < 0.1);
    }
}

TEST_CASE("the energy of oscillators that are little disturbed errs by as much as that") {
    using Many = made::SplitDisturbeds;
    std::vector<Many::Parameters> own(10);
    for (std::size_t i = 0; i < own.size(); ++i) { own[i].eps = 1e-5 * static_cast<double>(1 + i); }
    const std::vector<Many::Trajectory> x(own.size(), Many::initial());
    const std::vector<double> errors = energy_errors<Many>(x, own, 1.0 / 4, 200);
    for (std::size_t i = 0; i < own.size(); ++i) {
        CAPTURE(i);
        CHECK(errors[i] > 0);
        CHECK(std::abs(errors[i] / (errors[0] * static_cast<double>(1 + i)) - 1) < 1e-2);
    }
}

// ---- lanes ----

#if defined(__x86_64__) && !defined(__FMA__)
TEMPLATE_TEST_CASE("where no product is fused with a sum, bits are those of one trajectory", "",
                   SplitHenonHeiles, SplitMolecule, SplitTrap) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(19);
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(1.0 / 64, 300);
    for (std::size_t i = 0; i < x.size(); ++i) {
        typename TestType::One stepper;
        auto y = x[i];
        for (int step = 0; step < 300; ++step) { REQUIRE(stepper.step(y, 1.0 / 64).ok()); }
        CHECK(same_bits(ensemble.state(i), y));
    }
}
#endif

TEST_CASE("one that leaves for infinity lets the others stay") {
    using Many = made::SplitHenonHeileses;
    constexpr std::size_t gone = 10;
    constexpr std::int64_t steps = 4000;
    auto x = bound_stars(13);
    x[gone] = {{0.2, 0.9}, {0.1, 1.5}};  // above the saddle
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(1.0 / 16, steps);
    CHECK(ensemble.status(gone).code() == hvi::Status::Code::not_finite);
    CHECK(ensemble.steps(gone) > 0);
    CHECK(ensemble.steps(gone) < steps);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::isfinite(ensemble.state(gone).q[k]));
        CHECK(std::isfinite(ensemble.state(gone).p[k]));
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i == gone) { continue; }
        hvi::Ensemble<Many> alone({x[i]});
        alone.advance(1.0 / 16, steps);
        CHECK(ensemble.status(i).ok());
        CHECK(ensemble.steps(i) == steps);
        CHECK(same_bits(ensemble.state(i), alone.state(0)));
    }
}

TEST_CASE("sizes and parameters of lanes may change in any order") {
    using Many = made::SplitTraps;
    const auto x = starts<Many>(8);
    Many::Parameters other;
    other.field = 5;
    const auto end = [&](auto prepare) {
        Many::State state;
        Many stepper;
        for (std::size_t lane = 0; lane < 8; ++lane) { state.set(lane, x[lane]); }
        prepare(stepper, state);
        CHECK(stepper.step(state).ok());
        return state;
    };
    const auto sizes = [](Many& stepper) {
        for (std::size_t lane = 0; lane < 8; ++lane) { stepper.set_step(lane, 0.125); }
        stepper.set_step(2, -0.25);
    };
    const Many::State expected = end([&](Many& stepper, Many::State&) {
        stepper.set_parameters(5, other);
        sizes(stepper);
    });
    const Many::State later = end([&](Many& stepper, Many::State&) {
        sizes(stepper);
        stepper.set_parameters(5, other);
    });
    const Many::State after_a_step = end([&](Many& stepper, Many::State& state) {
        const Many::State start = state;
        CHECK(stepper.step(state, 0.5).ok());
        state = start;
        stepper.set_parameters(5, other);
        sizes(stepper);
    });
    const Many::State of_equal_sizes = end([&](Many& stepper, Many::State& state) {
        const Many::State start = state;
        sizes(stepper);
        CHECK(stepper.step(state).ok());
        state = start;
        stepper.set_parameters(5, other);
    });
    const Many::State shared = end([&](Many& stepper, Many::State&) { sizes(stepper); });
    for (std::size_t lane = 0; lane < 8; ++lane) {
        CHECK(same_bits(expected[lane], later[lane]));
        CHECK(same_bits(expected[lane], after_a_step[lane]));
        CHECK(same_bits(expected[lane], of_equal_sizes[lane]));
        CHECK(same_bits(expected[lane], shared[lane]) == (lane != 5));
    }
}
