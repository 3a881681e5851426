// Reductions: numbers of a whole run that a user wants of columns, `min(x), mean(energy)`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/read/table_columns.hpp"

namespace hvi::gen {

enum class ReductionKind { least, largest, mean };

/// A number made of all values of a column.
struct Reduction {
    std::string name;  ///< `min(x[3])`
    ReductionKind kind = ReductionKind::least;
    std::size_t column = 0;  ///< by its number
};

/// Reads a list of min, max and mean of columns, which are named as named_columns() reads them.
/// Each column has a reduction of its own. Throws InputError as named_columns() does, for an
/// unknown function and for a reduction that comes twice.
[[nodiscard]] std::vector<Reduction>
named_reductions(const Given& list, const std::vector<NameBox>& all, const WholeNumbers& sizes);

}  // namespace hvi::gen
