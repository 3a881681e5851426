// See test_two_units.cpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>

#include "systems.hpp"

hvi::Status step_in_second_unit(hvi::State<systems::One>& x, double h) {
    return hvi::generated::StormerVerletSeparable<systems::SeparableOscillator>{}.step(x, h);
}
