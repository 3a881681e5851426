// Numbers that a user wants of columns over a whole run: `min(x), mean(energy)`.
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

/// Reads a list of min, max and mean, each of columns as named_columns() reads them, of which each
/// has a reduction of its own. Throws InputError as that does, for an unknown function and for a
/// reduction that comes twice.
[[nodiscard]] std::vector<Reduction>
named_reductions(const Given& list, const std::vector<NameBox>& all, const WholeNumbers& sizes);

}  // namespace hvi::gen
