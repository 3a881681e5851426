// Stars of one galaxy, each with its own start: how far their energies wander.
// SPDX-License-Identifier: MIT
//
// docs/steppers.md shows this program.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <henon_heiles_ensemble.hpp>
#include <hvi/ensemble.hpp>

using HenonHeiles = hvi::generated::HenonHeiles;

int main() {
    std::vector<HenonHeiles::Trajectory> starts(10'000, HenonHeiles::initial());
    for (std::size_t i = 0; i < starts.size(); ++i) {
        starts[i].p[0] *= static_cast<double>(i) / 10'000.0;
    }
    hvi::Ensemble<HenonHeiles> stars(starts);
    stars.advance(0.1, 1000);  // the size of a step, and how many

    double worst = 0;
    for (std::size_t i = 0; i < stars.size(); ++i) {
        if (!stars.status(i).ok()) {
            std::printf("star %zu stopped after %lld steps: %s\n", i,
                        static_cast<long long>(stars.steps(i)), stars.status(i).message());
            return 1;
        }
        const double change =
            stars.stepper().energy(stars.state(i)) - stars.stepper().energy(starts[i]);
        worst = std::max(worst, std::abs(change));
    }
    std::printf("largest change of an energy: %.1e\n", worst);
    return worst < 1e-6 ? 0 : 1;
}
