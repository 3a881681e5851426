// The values in which the rows of an ensemble differ.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/ensembles/grid.hpp"
#include "generator/ensembles/laws.hpp"
#include "generator/ensembles/number_rows.hpp"
#include "generator/ensembles/row_plan.hpp"

namespace hvi::gen {

/// All ways in which rows differ: each row of a file, with each point of the grids, with each
/// sample of the laws. Rows of the file come slowest, then the first grid; samples come fastest.
struct RowSources {
    Given file;  ///< may be none
    std::vector<Grid> grids;
    std::vector<Law> laws;
    std::int64_t samples = 1;
    std::uint64_t seed = 0;
};

/// Values of rows by their numbers.
class RowSource {
public:
    /// Throws as number_rows() does, and InputError where there are more than 10^15 rows.
    explicit RowSource(const RowSources& sources);

    /// Returns a source of the same values that shares no open file with this one. Throws as the
    /// constructor does.
    [[nodiscard]] RowSource again() const { return RowSource(sources_); }

    /// Returns the names of the values: columns of the file, grids, laws.
    [[nodiscard]] const std::vector<VariedName>& names() const { return names_; }
    [[nodiscard]] std::int64_t count() const { return count_; }
    /// Identifies all values.
    [[nodiscard]] std::string key() const;

    /// Returns the values of a row, one for each name. Throws as NumberRows does.
    [[nodiscard]] std::vector<double> at(std::int64_t row);

private:
    [[nodiscard]] std::vector<double> row_of_file(std::int64_t row);

    RowSources sources_;
    std::unique_ptr<NumberRows> file_;
    std::vector<VariedName> names_;
    std::int64_t count_ = 1;
    std::vector<double> block_;  ///< rows of the file, the last ones that were read
    std::int64_t first_in_block_ = -1;
};

}  // namespace hvi::gen
