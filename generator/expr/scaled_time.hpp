// Steps of another variable than time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// H of a scene in which time is a coordinate, since its steps are of another variable.
struct ScaledTime {
    std::size_t coordinate;  ///< that is the time
    Expression energy;  ///< H before, and where it depends on the time the momentum of that too
    bool drifts_first;  ///< explicit methods begin with a drift
};

}  // namespace hvi::gen
