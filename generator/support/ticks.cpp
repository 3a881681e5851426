// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/ticks.hpp"

#include <cmath>
#include <initializer_list>

namespace hvi::gen {

double distance_of_ticks(double length, double most) {
    const double power = std::pow(10.0, std::floor(std::log10(length / most)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (length <= most * factor * power) { return factor * power; }
    }
    return 10 * power;
}

}  // namespace hvi::gen
