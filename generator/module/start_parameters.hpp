// Starting values as parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A system that begins at parameters of its own, which are the last ones, and their correctly
/// rounded values.
struct StartParameters {
    System system;
    std::vector<double> values;
};

/// Makes parameters of the starting values that depend on parameters only. Makes none where one of
/// their values cannot be computed here, or where there are thousands. NOTE: only a compiler knows
/// values of the user's own functions, and thousands are too many words for a command line.
[[nodiscard]] StartParameters with_start_parameters(System system);

}  // namespace hvi::gen
