// The derivatives in generated headers against finite differences of the energy in them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <random>

#include <catch2/catch.hpp>
#include <scene/newton_double_pendulum.hpp>
#include <scene/newton_kepler.hpp>

#include "scenes.hpp"

namespace {

/// Returns the derivative by Richardson's extrapolation of central differences.
template <class F>
double derivative(F f, double x, double d) {
    const auto central = [&](double e) { return (f(x + e) - f(x - e)) / (2 * e); };
    return (4 * central(d / 2) - central(d)) / 3;
}

/// A state near the start, each component moved by a random part of its size.
template <class Stepper>
typename Stepper::State near_start(std::mt19937& random) {
    typename Stepper::State x = Stepper::initial();
    std::uniform_real_distribution<double> part(-0.1, 0.1);
    double size = 0.0;
    for (const auto* y : {&x.q, &x.p}) {
        for (const double value : *y) { size = std::max(size, std::abs(value)); }
    }
    for (auto* y : {&x.q, &x.p}) {
        for (double& value : *y) {
            value += part(random) * (value == 0.0 ? 0.01 * size : std::abs(value));
        }
    }
    return x;
}

struct CompareGradient {
    template <class Stepper>
    void operator()() const {
        const Stepper stepper;
        const typename Stepper::System system{typename Stepper::Parameters{}};
        std::mt19937 random(7);
        for (int round = 0; round < 5; ++round) {
            const typename Stepper::State x = near_start<Stepper>(random);
            typename Stepper::Vector dq{}, dp{};
            scenes::gradient(system, x.q, x.p, dq, dp);
            check(stepper, x, &Stepper::State::q, dq);
            check(stepper, x, &Stepper::State::p, dp);
        }
    }

    template <class Stepper, class State, class Part, class Vector>
    static void check(const Stepper& stepper, const State& x, Part part, const Vector& slope) {
        const double energy = std::abs(stepper.energy(x));
        for (std::size_t k = 0; k < slope.size(); ++k) {
            const auto along = [&](double value) {
                State moved = x;
                (moved.*part)[k] = value;
                return stepper.energy(moved);
            };
            const double at = (x.*part)[k];
            const double d = 1e-3 * (at == 0.0 ? 1.0 : std::abs(at));
            const double rounding = 1e-14 * energy / d;
            CAPTURE(k, at);
            CHECK(slope[k] == Approx(derivative(along, at, d)).epsilon(1e-7).margin(rounding));
        }
    }
};

using Matrix = hvi::detail::SquareMatrix<double>;

/// The Hessian against differences of the gradient.
template <class Stepper, class Hessian>
void compare_hessian(const typename Stepper::State& x, Hessian hessian) {
    constexpr std::size_t n = std::tuple_size_v<typename Stepper::Vector>;
    const typename Stepper::System system{typename Stepper::Parameters{}};
    std::array<Matrix, 3> blocks;  // qq, qp, pp
    for (Matrix& block : blocks) { block = Matrix(n); }
    hessian(system, x, blocks);
    const auto slope = [&](typename Stepper::State moved, bool by_q, std::size_t i) {
        typename Stepper::Vector dq{}, dp{};
        scenes::gradient(system, moved.q, moved.p, dq, dp);
        return by_q ? dq[i] : dp[i];
    };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const auto moved_q = [&](double value) {
                typename Stepper::State y = x;
                y.q[j] = value;
                return y;
            };
            const auto moved_p = [&](double value) {
                typename Stepper::State y = x;
                y.p[j] = value;
                return y;
            };
            const auto close = [](double expected) { return Approx(expected).margin(1e-8); };
            CHECK(blocks[0](i, j) ==
                  close(derivative([&](double v) { return slope(moved_q(v), true, i); }, x.q[j],
                                   1e-3)));
            CHECK(blocks[1](i, j) ==
                  close(derivative([&](double v) { return slope(moved_p(v), true, i); }, x.p[j],
                                   1e-3)));
            CHECK(blocks[2](i, j) ==
                  close(derivative([&](double v) { return slope(moved_p(v), false, i); }, x.p[j],
                                   1e-3)));
        }
    }
}

}  // namespace

TEST_CASE("gradients of all scenes") { scenes::for_each(CompareGradient{}); }

TEST_CASE("a Hessian, of separable H and of H that is not") {
    std::mt19937 random(8);
    using Separable = hvi::generated::NewtonKepler;
    compare_hessian<Separable>(near_start<Separable>(random),
                               [](const auto& system, const auto& x, auto& blocks) {
                                   system.d2Hdq2(x.q, blocks[0]);
                                   // NOTE: Newton's method for positions asks for no more.
                                   blocks[2].set_identity();
                               });
    using General = hvi::generated::NewtonDoublePendulum;
    auto x = near_start<General>(random);
    x.p = {0.5, -0.25};
    compare_hessian<General>(x, [](const auto& system, const auto& y, auto& blocks) {
        system.d2Hdq2(y.q, y.p, blocks[0]);
        system.d2Hdqdp(y.q, y.p, blocks[1]);
        system.d2Hdp2(y.q, y.p, blocks[2]);
    });
}
