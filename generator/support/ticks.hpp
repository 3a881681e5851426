// Where the axes of pictures have ticks.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// How far apart they are: 1, 2 or 5 times a power of ten, the least of these that fits into
/// `length` at most so many times. Preconditions: length > 0, most >= 1.
[[nodiscard]] double distance_of_ticks(double length, double most);

}  // namespace hvi::gen
