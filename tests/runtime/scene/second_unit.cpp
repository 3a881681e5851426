// SPDX-License-Identifier: GPL-2.0-or-later
#include <scene/kepler.hpp>
#include <scene/verlet_kepler.hpp>

double end_in_second_unit();

double end_in_second_unit() {
    hvi::generated::Kepler stepper;
    hvi::generated::Kepler::State x = hvi::generated::Kepler::initial();
    for (int i = 0; i < 10; ++i) {
        if (!stepper.step(x, 0.05).ok()) { return 0.0; }
    }
    return x.q[0];
}
