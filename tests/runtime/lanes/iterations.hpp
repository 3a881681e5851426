// How many iterations a step takes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <catch2/catch.hpp>

/// Returns the iterations a step, including failed attempts, over `steps` steps from x.
template <class Stepper>
double iterations(Stepper stepper, typename Stepper::State x, double h, int steps) {
    long count = 0;
    for (int i = 0; i < steps; ++i) {
        const auto status = stepper.step(x, h);
        REQUIRE(status.ok());
        count += status.iterations;
    }
    return static_cast<double>(count) / steps;
}
