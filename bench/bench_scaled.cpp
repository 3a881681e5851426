// Steps that adapt by scaled time beside steps of fixed sizes, and beside the controlled steppers
// of Boost.Odeint: a comet of the eccentricity 0.99 over ten orbits. A table of the error at the
// end and of the time that it takes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include <boost/numeric/odeint.hpp>
#include <hvi/events.hpp>

#include "scaled/fixed_gauss_8.hpp"
#include "scaled/fixed_kahan_li.hpp"
#include "scaled/gauss_8.hpp"
#include "scaled/kahan_li.hpp"

namespace {

constexpr double ecc = 0.99, orbits = 10;
const double period = 2 * std::acos(-1.0);

using Body = std::array<double, 4>;  // x, y, px, py

Body start() { return {1 - ecc, 0, 0, std::sqrt((1 + ecc) / (1 - ecc))}; }

/// The largest error of a coordinate in half axes, and of a momentum in its largest value.
double error_of(const Body& end) {
    double largest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double scale = k < 2 ? 1 : start()[3];
        largest = std::max(largest, std::abs(end[k] - start()[k]) / scale);
    }
    return largest;
}

/// Runs it again and again, and prints the least time.
template <class Run>
void measure(const char* name, const char* knob, double value, Run run) {
    using Clock = std::chrono::steady_clock;
    constexpr int times = 5;
    double best = HUGE_VAL;
    Body end{};
    for (int k = 0; k < times; ++k) {
        const auto begin = Clock::now();
        end = run();
        best =
            std::min(best, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
    }
    std::printf("%-34s %s = %-8g error %8.1e  %10.1f us\n", name, knob, value, error_of(end), best);
}

/// Steps of a fixed size in t.
template <class Stepper>
void fixed(const char* name, int steps) {
    measure(name, "steps an orbit", steps, [&] {
        Stepper stepper;
        auto x = Stepper::initial();
        const auto all = static_cast<std::int64_t>(orbits) * steps;
        for (std::int64_t k = 0; k < all; ++k) {
            if (!stepper.step(x, period / steps).ok()) { return Body{}; }
        }
        return Body{x.q[0], x.q[1], x.p[0], x.p[1]};
    });
}

/// Steps of a fixed size in the logarithmic time, whose length an orbit is 2 pi; the last one ends
/// where t does.
template <class Stepper>
void scaled(const char* name, int steps) {
    measure(name, "steps an orbit", steps, [&] {
        Stepper stepper;
        auto x = Stepper::initial();
        hvi::Event<Stepper> end;
        end.zero = [](const auto& y, double) { return y.q[2] - orbits * period; };
        end.act = [](auto&, double) { return hvi::After::stop; };
        const auto most = static_cast<std::int64_t>(2 * orbits) * steps;
        const auto run =
            hvi::integrate(stepper, x, 0.0, period / steps, most, hvi::events(std::move(end)));
        return run.ok() ? Body{x.q[0], x.q[1], x.p[0], x.p[1]} : Body{};
    });
}

template <class Method>
void controlled(const char* name, double tolerance) {
    namespace odeint = boost::numeric::odeint;
    measure(name, "tolerance", tolerance, [&] {
        Body x = start();
        const auto field = [](const Body& at, Body& out, double) {
            const double square = at[0] * at[0] + at[1] * at[1];
            const double cube = square * std::sqrt(square);
            out = {at[2], at[3], -at[0] / cube, -at[1] / cube};
        };
        odeint::integrate_adaptive(odeint::make_controlled<Method>(tolerance, tolerance), field, x,
                                   0.0, orbits * period, 1e-6);
        return x;
    });
}

}  // namespace

int main() {
    namespace odeint = boost::numeric::odeint;
    using namespace hvi::generated;
    for (const int steps : {6000, 12'000, 24'000}) {
        fixed<FixedGauss8>("gauss:8, fixed steps", steps);
    }
    for (const int steps : {20'000, 40'000, 80'000}) {
        fixed<FixedKahanLi>("kahan-li:8, fixed steps", steps);
    }
    for (const int steps : {20, 40, 80}) { scaled<KahanLi>("kahan-li:8, logarithmic", steps); }
    for (const int steps : {20, 40, 80}) { scaled<Gauss8>("gauss:8, logarithmic", steps); }
    for (const double tolerance : {1e-8, 1e-10, 1e-12, 1e-14}) {
        controlled<odeint::runge_kutta_fehlberg78<Body>>("Odeint, fehlberg78, controlled",
                                                         tolerance);
    }
    for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
        controlled<odeint::runge_kutta_dopri5<Body>>("Odeint, dopri5, controlled", tolerance);
    }
}
