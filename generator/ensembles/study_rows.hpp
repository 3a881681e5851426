// The rows of a study, as far as they are there.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "generator/ensembles/study.hpp"

namespace hvi::gen {

/// Returns the numbers of the chunks that are not computed yet, ascending.
[[nodiscard]] std::vector<std::int64_t> missing_chunks(const Study& study);

/// Calls see(row) for each row that is there, in their order, and shows progress. Throws
/// EnvironmentError where a chunk is damaged.
void for_each_row(const Study& study, const std::function<void(const std::vector<double>&)>& see);

}  // namespace hvi::gen
