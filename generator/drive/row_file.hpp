// A file of rows of numbers with names, in one of several formats.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/read/table_columns.hpp"

namespace hvi::gen {

/// Rows of doubles. close() reports whether all of them were written.
class RowFile {
public:
    RowFile() = default;
    virtual ~RowFile() = default;
    RowFile(const RowFile&) = delete;
    RowFile& operator=(const RowFile&) = delete;

    virtual void row(const std::vector<double>& values) = 0;
    [[nodiscard]] virtual bool good() const = 0;
    /// Returns the number of bytes, all handed to the system; -1 where that failed.
    [[nodiscard]] virtual std::int64_t flushed_size() = 0;
    [[nodiscard]] virtual bool close() = 0;
};

struct NamedColumn {
    std::string name;
    std::string meaning;  ///< its kind: `momentum px`
    TableNumbers numbers = TableNumbers::doubles;
    std::span<const std::string_view> words = {};  ///< by their numbers; CSV has them in place of
                                                   ///< the numbers
};

/// Returns the nearest float by IEC 60559: infinite where the value is beyond the largest one.
[[nodiscard]] inline float nearest_float(double value) { return static_cast<float>(value); }

/// A note about the run of a table: a text, or a number.
struct TableNote {
    std::string name;
    std::variant<std::string, double> value;
};

/// The head of a table, as far as the format has a place for it.
struct TableHead {
    std::vector<NamedColumn> columns;
    std::vector<TableNote> notes;
};

/// Throws EnvironmentError where tables of this format cannot be written on this machine.
void check_format(TableFormat format);

/// Makes a new file; or one that continues after `size` bytes of a file with an equal head and
/// format.
///
/// NPY is an array of records, one field for each name, that NumPy reads:
/// numpy.load(file)["energy"]. Preconditions: the format is checked, and an HDF5 file is new.
[[nodiscard]] std::unique_ptr<RowFile> row_file(TableFormat format,
                                                const std::filesystem::path& path,
                                                const TableHead& head,
                                                std::optional<std::int64_t> size = {});

/// Writes into a closed table why it is incomplete, as far as the format has a place for it.
/// Returns false where that cannot be written.
[[nodiscard]] bool mark_incomplete(TableFormat format, const std::filesystem::path& path,
                                   const std::string& why);

}  // namespace hvi::gen
