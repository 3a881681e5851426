// A planet on an orbit of eccentricity 1/5 for a thousand revolutions: a stepper that hvi-gen wrote
// for this scene alone, an observer, and how far energy and angular momentum have moved.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <hvi/integrate.hpp>

#include "kepler_gauss_4.hpp"

using Kepler = hvi::generated::KeplerGauss4;

int main() {
    Kepler::Parameters parameters;  // as in the scene: mu = 1, ecc = 3/5
    parameters.ecc = 0.2;
    Kepler stepper{parameters};
    Kepler::State x = Kepler::initial(parameters);

    const double energy = stepper.energy(x);
    const double angular_momentum = stepper.angular_momentum(x);
    double energy_error = 0.0;
    const auto observe = [&](const Kepler::State& y, double /*t*/) {
        energy_error = std::max(energy_error, std::abs(stepper.energy(y) - energy));
    };
    const double h = 2.0 * std::acos(-1.0) / 100;
    const hvi::Run run = hvi::integrate(stepper, x, 0.0, h, 100'000, observe);
    if (!run.ok()) {
        std::fprintf(stderr, "step %lld: %s\n", static_cast<long long>(run.steps) + 1,
                     run.status.message());
        return 1;
    }
    std::printf("x = %.9f  y = %.9f after %lld steps of %.1f iterations\n", x.q[0], x.q[1],
                static_cast<long long>(run.steps),
                static_cast<double>(run.iterations) / static_cast<double>(run.steps));
    std::printf("energy error = %.1e  of the angular momentum: %.1e\n", energy_error,
                std::abs(stepper.angular_momentum(x) - angular_momentum));
}
