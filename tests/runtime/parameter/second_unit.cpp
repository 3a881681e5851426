// See test_steps.cpp: the copy of the runtime in a header without a solver comes after the runtime
// itself here, and before it there.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <hvi/detail/coefficients/parameter.hpp>

#include "parameter/cosine_separable.hpp"
#include "tests/runtime/run/systems.hpp"

hvi::Status step_in_second_unit(hvi::State<systems::One>& x, double w, double h) {
    return hvi::generated::CosineSeparable<systems::SeparableOscillator>({}, w).step(x, h);
}
