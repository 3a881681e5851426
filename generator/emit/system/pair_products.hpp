// Products of second derivatives by sums, where stages have positions and momenta, in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/emit/system/loop_writer.hpp"

namespace hvi::gen {

/// Writes members d2Hdq and d2Hdp of a system: rows of d2H times a vector (way, way_p). Where
/// H = T(p) + U(q) each takes what it depends on alone.
void write_pair_products(Writer& writer, LoopWriter& loops);

}  // namespace hvi::gen
