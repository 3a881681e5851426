// Prints for step sizes h, a factor apart, what a unit of time costs: h, iterations, microseconds.
//     step-sizes FROM TO COUNT
// Ends at the first h for which some step has no solution. HEADER and STEPPER are macros.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include HEADER

namespace {

using Stepper = hvi::generated::STEPPER;
using Clock = std::chrono::steady_clock;

constexpr int steps = 200;

/// Of so many steps; negative where one failed.
long iterations(double h) {
    Stepper stepper;
    auto x = Stepper::initial();
    long count = 0;
    for (int i = 0; i < steps; ++i) {
        const auto status = stepper.step(x, h);
        if (!status.ok()) { return -1; }
        count += status.iterations;
    }
    return count;
}

/// The shortest of several runs.
double seconds(double h) {
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 9; ++round) {
        const auto begin = Clock::now();
        static_cast<void>(iterations(h));
        least = std::min(least, std::chrono::duration<double>(Clock::now() - begin).count());
    }
    return least;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) { return 2; }
    const double from = std::atof(argv[1]), to = std::atof(argv[2]);
    const int count = std::atoi(argv[3]);
    for (int i = 0; i < count; ++i) {
        const double h = from * std::pow(to / from, i / (count - 1.0));
        const long found = iterations(h);
        if (found < 0) { break; }
        const double time = steps * h;
        std::printf("%.6g %.6g %.6g\n", h, static_cast<double>(found) / time,
                    1e6 * seconds(h) / time);
    }
}
