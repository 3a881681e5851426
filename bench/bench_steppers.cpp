// Generated steppers against loops written by hand and against the table-driven stepper.
// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/generic_stepper.hpp>

#include "by_hand.hpp"
#include "problems.hpp"
#include "report.hpp"

namespace {

constexpr int steps = 1000;

// NOTE: read through a volatile so that no compiler folds it, and not passed to DoNotOptimize(),
// which spoils a double that lives in a register when g++ compiles it.
double step_size() {
    static volatile double h = 0.01;
    return h;
}

void verlet_by_hand(benchmark::State& state) {
    const double h = step_size();
    bench::VerletByHand stepper(1.5, 0.0);
    for (auto _ : state) {
        for (int i = 0; i < steps; ++i) { stepper.step(h); }
        benchmark::DoNotOptimize(stepper.q() + stepper.p());
    }
}
BENCHMARK(verlet_by_hand);

void gauss_by_hand(benchmark::State& state) {
    const double h = step_size();
    bench::Gauss2ByHand stepper(bench::pericentre());
    for (auto _ : state) {
        for (int i = 0; i < steps; ++i) {
            if (!stepper.step(h)) { state.SkipWithError("no convergence"); }
        }
        benchmark::DoNotOptimize(stepper.qx() + stepper.py());
    }
}
BENCHMARK(gauss_by_hand);

/// So many steps in a loop like a user's, which leaves at the first that fails. NOTE: apart from
/// the benchmark's own calls, which would keep g++ from holding the state in registers.
template <class Stepper, class State>
hvi::Status advance(Stepper& given, State& start, double h, long& iterations) {
    Stepper stepper = given;
    State x = start;
    hvi::Status status;
    for (int i = 0; i < steps && status.ok(); ++i) {
        status = stepper.step(x, h);
        iterations += status.iterations;
    }
    given = stepper;
    start = x;
    return status;
}

template <class Stepper, class State>
void run(benchmark::State& state, const Stepper& fresh, const State& start) {
    Stepper stepper = fresh;
    State x = start;
    const double h = step_size();
    long iterations = 0;
    for (auto _ : state) {
        const hvi::Status status = advance(stepper, x, h, iterations);
        if (!status.ok()) { state.SkipWithError(status.message()); }
        benchmark::DoNotOptimize(x.q[0] + x.p[0]);
    }
    const auto taken = static_cast<double>(state.iterations()) * steps;
    state.counters["iterations"] = static_cast<double>(iterations) / taken;
}

void verlet_generated(benchmark::State& state) {
    using Stepper = hvi::generated::StormerVerletSeparable<bench::Pendulum>;
    run(state, Stepper{}, Stepper::State{{1.5}, {0.0}});
}
BENCHMARK(verlet_generated);

void gauss_generated(benchmark::State& state) {
    run(state, hvi::generated::Gauss2<bench::Kepler>{}, bench::pericentre());
}
BENCHMARK(gauss_generated);

void gauss_generated_separable(benchmark::State& state) {
    run(state, hvi::generated::Gauss2Separable<bench::SeparableKepler>{}, bench::pericentre());
}
BENCHMARK(gauss_generated_separable);

void gauss_from_table(benchmark::State& state) {
    using Vector = hvi::GenericStepper<double>::Vector;
    const double root = std::sqrt(3.0) / 6;
    const std::vector<std::vector<double>> A{{0.25, 0.25 - root}, {0.25 + root, 0.25}};
    const hvi::GenericStepper<double> stepper(
        {{0.5, 0.5}, A, A},
        [](const Vector& q, const Vector&, Vector& out) {
            const double r2 = q[0] * q[0] + q[1] * q[1];
            const double scale = 1.0 / (r2 * std::sqrt(r2));
            out[0] = scale * q[0];
            out[1] = scale * q[1];
        },
        [](const Vector&, const Vector& p, Vector& out) { out = p; });
    run(state, stepper, hvi::GenericStepper<double>::State{{0.4, 0.0}, {0.0, 2.0}});
}
BENCHMARK(gauss_from_table);

}  // namespace

int main(int argc, char** argv) {
    return bench::time_all(argc, argv,
                           {{"verlet_generated", "verlet_by_hand", "at most 1.1"},
                            {"gauss_generated", "gauss_by_hand", "at most 1.2"},
                            {"gauss_from_table", "gauss_generated", "at least 4"},
                            {"gauss_from_table", "gauss_generated_separable", "at least 4"}});
}
