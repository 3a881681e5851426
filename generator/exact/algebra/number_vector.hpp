// Types of vectors and matrices of exact numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

using NumberVector = std::vector<Number>;
using NumberMatrix = std::vector<NumberVector>;  ///< rows

}  // namespace hvi::gen
