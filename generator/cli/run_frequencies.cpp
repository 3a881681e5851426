// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_frequencies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "generator/drive/table.hpp"

namespace hvi::gen {

namespace {

/// Returns the first terms after the mean, `1.41421 +- 2e-13 (amplitude 0.5)`. Leaves out terms
/// that may be rounding errors.
std::string said_of(const ColumnFrequencies& column) {
    constexpr std::size_t most = 3;
    constexpr double little = 1e-10;
    if (column.terms.empty())
        return column.name + ": not analysed, as rows are too few or have no finite number";
    std::vector<std::string> all;
    for (std::size_t k = 1; k < std::min(column.terms.size(), most + 1); ++k) {
        const FrequencyTerm& term = column.terms[k];
        if (term.amplitude < little * column.terms[1].amplitude) break;
        all.push_back(fmt::format("{:.15g} +- {:.0e} (amplitude {:.4g})", term.frequency,
                                  term.uncertainty, term.amplitude));
    }
    return fmt::format("{}: {}", column.name,
                       all.empty() ? "constant" : fmt::format("{}", fmt::join(all, ", ")));
}

std::int64_t count_of_rows(const WishedRun& wished) {
    return wished.times.empty() ? wished.steps.count + 1
                                : static_cast<std::int64_t>(wished.times.size());
}

}  // namespace

std::vector<ColumnBox> analysed_columns(const WishedRun& wished, const RunOptions& options) {
    if (!options.frequencies) return {};
    const std::vector<ColumnBox> columns =
        named_columns(options.frequencies, column_names(wished.subject), wished.subject.sizes);
    const Place place = whole(options.frequencies);
    if (wished.clock && wished.times.empty())
        throw InputError("--frequencies takes rows at equal distances of time, and steps of scaled "
                         "time are not",
                         place, "--times FROM:TO:COUNT makes such rows");
    const std::int64_t rows = count_of_rows(wished);
    if (rows < static_cast<std::int64_t>(fewest_samples))
        throw InputError(fmt::format("--frequencies takes {} rows at least, and here are {}",
                                     fewest_samples, rows),
                         place, "more steps, or a later --until");
    return columns;
}

std::vector<std::pair<std::string, std::string>>
lines_of(const std::vector<ColumnFrequencies>& found) {
    std::vector<std::pair<std::string, std::string>> lines;
    for (const ColumnFrequencies& column : found)
        lines.emplace_back("frequencies", said_of(column));
    return lines;
}

std::string table_of(const std::vector<ColumnFrequencies>& found) {
    std::string text = "column,number,frequency,amplitude,phase,uncertainty\n";
    for (const ColumnFrequencies& column : found) {
        std::size_t number = 0;
        for (const FrequencyTerm& term : column.terms)
            text += fmt::format("{},{},{},{},{},{}\n", text_of_cell(column.name), number++,
                                term.frequency, term.amplitude, term.phase, term.uncertainty);
    }
    return text;
}

}  // namespace hvi::gen
