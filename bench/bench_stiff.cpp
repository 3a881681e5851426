// Stiff chains: how the time of Newton's method grows with their length.
// SPDX-License-Identifier: MIT
//
// The FPU chain of fpu-chain at h omega = 10, omega = 2 its largest frequency, from its first modes
// with an amplitude at which springs are not linear. Lengths go in turn, five rounds of them, and
// of each the fastest round counts.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>

#include <stiff/chain_gauss_2.hpp>
#include <stiff/chain_gauss_4.hpp>

namespace {

struct Timed {
    double seconds_of_step = 1e300, iterations = 0;
};

template <class Stepper>
Timed timed(std::ptrdiff_t n) {
    typename Stepper::Parameters parameters;
    parameters.N = n;
    parameters.amplitude = 1;
    Stepper stepper(parameters);
    auto x = Stepper::initial(parameters);
    for (std::size_t i = 0; i < x.q.size(); ++i) {
        x.q[i] += 0.1 * std::sin(0.3 * static_cast<double>(i));
    }
    const auto step = [&] {
        const hvi::Status status = stepper.step(x, 5.0);
        if (!status.ok()) { std::printf("%s\n", status.message()); }
        return status.iterations;
    };
    step();
    const int steps = static_cast<int>(std::max<std::ptrdiff_t>(200000 / n, 4));
    std::int64_t iterations = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < steps; ++k) { iterations += step(); }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    return {time.count() / steps, static_cast<double>(iterations) / steps};
}

/// The exponent of time = constant n^exponent by least squares.
double fitted_exponent(const std::ptrdiff_t* n, const Timed* times, std::size_t count) {
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double a = std::log(static_cast<double>(n[k])),
                     b = std::log(times[k].seconds_of_step);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    const auto all = static_cast<double>(count);
    return (all * xy - x * y) / (all * xx - x * x);
}

template <class Stepper>
void report(const char* name) {
    constexpr std::ptrdiff_t n[] = {100, 316, 1000, 3162, 10000, 31623, 100000};
    constexpr std::size_t count = std::size(n);
    Timed best[count];
    for (int round = 0; round < 5; ++round) {
        for (std::size_t k = 0; k < count; ++k) {
            const Timed now = timed<Stepper>(n[k]);
            if (now.seconds_of_step < best[k].seconds_of_step) { best[k] = now; }
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        std::printf("%-8s n = %6td: %9.1f us a step, %6.1f ns a particle, %.1f iterations\n", name,
                    n[k], 1e6 * best[k].seconds_of_step,
                    1e9 * best[k].seconds_of_step / static_cast<double>(n[k]), best[k].iterations);
    }
    std::printf("%-8s time grows as n^%.2f   (at most 1.1)\n", name,
                fitted_exponent(n, best, count));
}

}  // namespace

int main() {
    report<hvi::generated::ChainGauss2>("gauss:2");
    report<hvi::generated::ChainGauss4>("gauss:4");
    return 0;
}
