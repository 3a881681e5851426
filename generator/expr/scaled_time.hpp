// Time as a coordinate, for steps of another variable.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// The H of a scene in which time is a coordinate, since its steps are of another variable.
struct ScaledTime {
    std::size_t coordinate;  ///< the number of the coordinate time
    Expression energy;       ///< the former H; plus the time's momentum if H depends on time
    bool drifts_first;       ///< explicit methods begin with a drift
};

}  // namespace hvi::gen
