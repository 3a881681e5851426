// Starting values as parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A system that begins at parameters of its own, the last ones, and their values: correctly
/// rounded.
struct StartParameters {
    System system;
    std::vector<double> values;
};

/// Makes parameters of the starting values that depend on parameters alone. None is one where the
/// value of any has no number here, or where there are thousands. NOTE: of functions of the user's
/// own only a compiler knows values, and thousands are too many words for a command line.
[[nodiscard]] StartParameters with_start_parameters(System system);

}  // namespace hvi::gen
