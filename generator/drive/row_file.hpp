// A file of rows of numbers with names, in one of several formats.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
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

/// A new file; or one that goes on behind so many bytes of a file of the same names and format.
///
/// NPY is an array of records, one field a name, that NumPy reads: numpy.load(file)["energy"].
[[nodiscard]] std::unique_ptr<RowFile> row_file(TableFormat format,
                                                const std::filesystem::path& path,
                                                const std::vector<std::string>& names,
                                                std::optional<std::int64_t> size = {});

}  // namespace hvi::gen
