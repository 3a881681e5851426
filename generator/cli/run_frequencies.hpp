// `hvi-gen run --frequencies COLUMNS`: the columns, and the report on them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/cli/run_summary.hpp"

namespace hvi::gen {

/// Returns the columns whose frequencies are wished for. Throws InputError for unknown names, too
/// few rows, and steps of scaled time.
[[nodiscard]] std::vector<ColumnBox> analysed_columns(const WishedRun& wished,
                                                      const RunOptions& options);

/// Lines of the summary: a name and the first frequencies of a column.
[[nodiscard]] std::vector<std::pair<std::string, std::string>>
lines_of(const std::vector<ColumnFrequencies>& found);

/// Returns the text of `frequencies.csv`.
[[nodiscard]] std::string table_of(const std::vector<ColumnFrequencies>& found);

}  // namespace hvi::gen
