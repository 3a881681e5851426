// Linear independence of functions, by their values.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/functions/function.hpp"

namespace hvi::gen {

/// Returns whether the matrix of the values of n functions at n points of (0, 1) is regular, which
/// proves them independent; false says nothing.
[[nodiscard]] bool proved_independent(const std::vector<ExactFunction>& functions);

}  // namespace hvi::gen
