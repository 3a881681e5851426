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

/// How a table is written.
enum class TableFormat { csv, npy, hdf5 };

/// Numbers that a table is made of, but for its times, which are doubles.
enum class TableNumbers { doubles, floats };

/// The values of an index, from the first to the last.
struct IndexRange {
    long first = 0, last = 0;
};

/// Names that differ in their indices, the last of which runs fastest: x[1..3], u[1..4,1..4]. With
/// no range it is one name without an index.
struct NameBox {
    std::string stem;
    std::vector<IndexRange> ranges;
};

/// That of one name: `x`, `x[3]`, `u[1,2]`.
[[nodiscard]] NameBox name_box(const std::string& name);

/// Some of the names in a box, as columns: the first one has this number, and numbers grow by the
/// strides with the indices.
struct ColumnBox {
    NameBox names;
    std::size_t number = 0;
    std::vector<std::size_t> strides;
};

/// The columns in a list of names, in its order: `x`, `x[2]`, `x[1..N]`, `u[1,1..3]`; a name that
/// has indices stands for all of them. `all` are there, numbered one after the other. Throws
/// InputError, with its place, for a name that is not among them and one that comes twice.
[[nodiscard]] std::vector<ColumnBox>
named_columns(const Given& list, const std::vector<NameBox>& all, const WholeNumbers& sizes);

/// Columns that a part of a list names. Precondition: `part` lies within its text.
[[nodiscard]] std::vector<ColumnBox> named_columns(const Given& list, Range part,
                                                   const std::vector<NameBox>& all,
                                                   const WholeNumbers& sizes);

/// Those of a table where nobody has named any, of at most 64 degrees of freedom all. Of more these
/// are the variables with the first three indices of each name, and what else there is. So many of
/// the boxes, the first ones, are `variables`: coordinates and momenta.
[[nodiscard]] std::vector<ColumnBox> usual_columns(const std::vector<NameBox>& all,
                                                   std::size_t variables);

/// How many columns stand before `x`, or `x[3]`; empty where it is none of them.
[[nodiscard]] std::optional<std::size_t> columns_before(const std::vector<ColumnBox>& columns,
                                                        const std::string& name);

/// The name with a number among all that are in the boxes, from 0 on; empty where there are not so
/// many.
[[nodiscard]] std::string name_at(const std::vector<NameBox>& boxes, std::size_t number);

/// Names in the boxes, in their order: all of a box with at most 64, of others those that are
/// columns, at most 64 of each.
[[nodiscard]] std::vector<std::string> names_in(const std::vector<NameBox>& boxes,
                                                const std::vector<ColumnBox>& columns);

/// Calls see(name, number) for each column, in their order.
void for_each_column(const std::vector<ColumnBox>& columns,
                     const std::function<void(const std::string&, std::size_t)>& see);

}  // namespace hvi::gen
