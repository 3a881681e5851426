// Three argon atoms whose potential is a spline through a table, see argon.toml. They begin at rest
// where a pair has half of the depth of its well, and breathe out to where it has that again.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "argon_steps.hpp"

using Argon = hvi::generated::ArgonSteps;

int main() {
    Argon stepper;
    Argon::State x = Argon::initial();
    const double energy = stepper.energy(x);
    double largest_error = 0, largest_side = 0;
    for (int step = 0; step < 2000; ++step) {
        if (const hvi::Status status = stepper.step(x, 0.002); !status.ok()) {
            std::puts(status.message());
            return 1;
        }
        largest_error = std::max(largest_error, std::abs(stepper.energy(x) - energy));
        largest_side = std::max(largest_side, std::hypot(x.q[0] - x.q[1], x.q[3] - x.q[4]));
    }
    const double turning = std::pow(4 / (2 - std::sqrt(2.0)), 1.0 / 6);
    std::printf("energy           %.6f, largest error %.1e\n", energy, largest_error);
    std::printf("largest distance %.6f, and %.6f of 4 (r^-12 - r^-6)\n", largest_side, turning);
    const bool is_right = std::abs(energy + 1.5) < 1e-3 && largest_error < 1e-3 &&
                          std::abs(largest_side - turning) < 1e-3;
    return is_right ? 0 : 1;
}
