// Ticks on the axes of pictures.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// Returns the distance of ticks: 1, 2 or 5 times a power of ten, the least that fits into `length`
/// at most `most` times. Preconditions: length > 0, most >= 1.
[[nodiscard]] double distance_of_ticks(double length, double most);

}  // namespace hvi::gen
