// The columns of a table that a user wants: `q[1..3], energy`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/read/unroll.hpp"

namespace hvi::gen {

/// Formats of a table.
enum class TableFormat { csv, npy, hdf5 };

/// Types of the numbers in a table. Its times are doubles always.
enum class TableNumbers { doubles, floats };

/// The values of an index, from the first to the last.
struct IndexRange {
    long first = 0, last = 0;
};

/// Names that differ in their indices, the last of which runs fastest: x[1..3], u[1..4,1..4].
/// Without ranges it is one name without an index.
struct NameBox {
    std::string stem;
    std::vector<IndexRange> ranges;
};

/// Returns the box of one name: `x`, `x[3]`, `u[1,2]`.
[[nodiscard]] NameBox name_box(const std::string& name);

/// Names in a box, as columns. The first column has the number `number`; a step in an index adds
/// its stride to it.
struct ColumnBox {
    NameBox names;
    std::size_t number = 0;
    std::vector<std::size_t> strides;
};

/// Returns the columns in a list of names, in its order: `x`, `x[2]`, `x[1..N]`, `u[1,1..3]`. A
/// name with omitted indices stands for all of them. `all` are the existing names, numbered one
/// after the other. Throws InputError, with its place, for a name that is not among them and for
/// one that comes twice.
[[nodiscard]] std::vector<ColumnBox>
named_columns(const Given& list, const std::vector<NameBox>& all, const WholeNumbers& sizes);

/// Returns the columns that a part of a list names. Precondition: `part` lies within its text.
[[nodiscard]] std::vector<ColumnBox> named_columns(const Given& list, Range part,
                                                   const std::vector<NameBox>& all,
                                                   const WholeNumbers& sizes);

/// Returns the columns of a table for which the user names none: all of them up to 64 degrees of
/// freedom. With more degrees of freedom it takes the first three indices of each variable, and all
/// other columns. The first `variables` boxes are coordinates and momenta.
[[nodiscard]] std::vector<ColumnBox> usual_columns(const std::vector<NameBox>& all,
                                                   std::size_t variables);

/// Returns the number of columns before `x`, or `x[3]`; empty where it is none of them.
[[nodiscard]] std::optional<std::size_t> columns_before(const std::vector<ColumnBox>& columns,
                                                        const std::string& name);

/// Returns the name with this number among all names in the boxes, from 0 on; empty where there are
/// not so many.
[[nodiscard]] std::string name_at(const std::vector<NameBox>& boxes, std::size_t number);

/// Returns the names in the boxes, in their order: all names of a box with at most 64. Of larger
/// boxes it returns the names of columns, at most 64 of each column box.
[[nodiscard]] std::vector<std::string> names_in(const std::vector<NameBox>& boxes,
                                                const std::vector<ColumnBox>& columns);

/// Calls see(name, number) for each column, in their order.
void for_each_column(const std::vector<ColumnBox>& columns,
                     const std::function<void(const std::string&, std::size_t)>& see);

}  // namespace hvi::gen
