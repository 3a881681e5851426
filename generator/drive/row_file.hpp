// A file of rows of numbers with names, in one of several formats.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/read/table_columns.hpp"

namespace hvi::gen {

/// Rows of doubles. Whether all of them were written is known at close().
class RowFile {
public:
    RowFile() = default;
    virtual ~RowFile() = default;
    RowFile(const RowFile&) = delete;
    RowFile& operator=(const RowFile&) = delete;

    virtual void row(const std::vector<double>& values) = 0;
    [[nodiscard]] virtual bool good() const = 0;
    /// How many bytes there are, all of which have left this process; -1 where they have not.
    [[nodiscard]] virtual std::int64_t flushed_size() = 0;
    [[nodiscard]] virtual bool close() = 0;
};

struct NamedColumn {
    std::string name;
    std::string meaning;  ///< for people: `momentum px`
    TableNumbers numbers = TableNumbers::doubles;
};

/// The nearest float as IEC 60559 has it: infinite where the value is beyond the largest one.
[[nodiscard]] inline float nearest_float(double value) { return static_cast<float>(value); }

/// A line on the run that a table is of: a text, or a number.
struct TableNote {
    std::string name;
    std::variant<std::string, double> value;
};

/// All that stands in a table before its rows, as far as the format has a place for it.
struct TableHead {
    std::vector<NamedColumn> columns;
    std::vector<TableNote> notes;
};

/// Throws EnvironmentError where tables of this format cannot be written on this machine.
void check_format(TableFormat format);

/// A new file; or one that goes on behind so many bytes of a file of the same head and format.
///
/// NPY is an array of records, one field a name, that NumPy reads: numpy.load(file)["energy"].
/// Preconditions: the format is checked, and HDF5 does not go on.
[[nodiscard]] std::unique_ptr<RowFile> row_file(TableFormat format,
                                                const std::filesystem::path& path,
                                                const TableHead& head,
                                                std::optional<std::int64_t> size = {});

/// Says in a table that is closed why it is not whole, as far as the format has a place for it.
/// False where it cannot be written.
[[nodiscard]] bool mark_incomplete(TableFormat format, const std::filesystem::path& path,
                                   const std::string& why);

}  // namespace hvi::gen
