// Rows of numbers with named columns, in a file of any length.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "generator/read/number_file.hpp"

namespace hvi::gen {

/// A file of rows, which stay in it until they are asked for.
class NumberRows {
public:
    virtual ~NumberRows() = default;
    NumberRows(const NumberRows&) = delete;
    NumberRows& operator=(const NumberRows&) = delete;

    /// Returns the names of the columns: at least one, none of them empty, no two equal.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// Returns the number of rows, at least 1.
    [[nodiscard]] std::int64_t count() const { return count_; }
    /// Returns the digest of the bytes of the file.
    [[nodiscard]] const std::string& digest() const { return digest_; }

    /// Reads rows [first, first + count), row by row, each with a number for each name. Numbers may
    /// be infinite or NaN. Throws InputError where the file has changed. Precondition: there are
    /// these rows.
    [[nodiscard]] virtual std::vector<double> rows(std::int64_t first, std::int64_t count) = 0;

protected:
    NumberRows(const NumberFile& file, std::vector<std::string> names, std::int64_t count);

private:
    std::vector<std::string> names_;
    std::int64_t count_;
    std::string digest_;
};

/// Opens a file of rows, whose path the user wrote:
///
///   * CSV: the first line has the names, in double quotes where a comma is in one, as in "u[1,2]".
///     A cell is a number, also `nan`, `inf` or empty, which is NaN. Blank lines and lines that
///     begin with # do not count. The file is read once, and places of lines are kept.
///   * NPY: a structured array of one dimension; its fields are numbers ('<f8', '<f4', '<i8',
///     '<i4').
///   * HDF5: the datasets of the root group, all of one dimension and one length.
///
/// Throws InputError, with the line of a CSV file: where there is no such file, a name comes twice,
/// there are no rows or no columns, a row is too short or too long, a cell is no number; and
/// EnvironmentError where HDF5's library is missing.
[[nodiscard]] std::unique_ptr<NumberRows> number_rows(const Given& file);

}  // namespace hvi::gen
