// The distance from 1 to the next double, in which errors are counted.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <limits>

namespace hvi::test {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace hvi::test
