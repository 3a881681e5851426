// A worker: computes chunks of a study.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "generator/ensembles/study.hpp"

namespace hvi::gen {

/// Computes some of the rows first, first + 1, ..., first + count - 1, from the first on; none
/// where a signal asks for the end.
using ComputeRows =
    std::function<std::vector<std::vector<double>>(std::int64_t first, std::int64_t count)>;

/// Computes the rows of a chunk and writes them. Returns false where a signal asks for the end: the
/// chunk then keeps the rows that it has, and whoever takes it goes on with them. `on_rows` hears
/// how many more there are. Throws as ComputeRows does, and EnvironmentError where a file cannot be
/// written or a started chunk is damaged.
bool compute_chunk(const Study& study, std::int64_t chunk, const ComputeRows& compute,
                   const std::function<void(std::int64_t)>& on_rows);

}  // namespace hvi::gen
