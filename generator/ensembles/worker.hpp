// A worker: computes chunks of a study.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "generator/ensembles/study.hpp"

namespace hvi::gen {

/// Computes a row by its number; nothing where a signal asks for the end.
using ComputeRow = std::function<std::optional<std::vector<double>>(std::int64_t)>;

/// Computes the rows of a chunk and writes them. Returns false where a signal asks for the end: the
/// chunk then keeps the rows that it has, and whoever takes it goes on with them. `on_row` is
/// called after each row. Throws as ComputeRow does, and EnvironmentError where a file cannot be
/// written or a started chunk is damaged.
bool compute_chunk(const Study& study, std::int64_t chunk, const ComputeRow& compute,
                   const std::function<void()>& on_row);

}  // namespace hvi::gen
