// A table as HDF5: a dataset for each column; all grow together.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/drive/hdf5_library.hpp"
#include "generator/drive/row_file.hpp"

namespace hvi::gen {

/// An object of HDF5. The destructor closes it.
class Hdf5Object {
public:
    using Close = herr_t (*)(hid_t);

    /// Throws Hdf5Failure where the library has not made the object.
    Hdf5Object(hid_t id, Close how);
    ~Hdf5Object() { static_cast<void>(close()); }
    Hdf5Object(Hdf5Object&& other) noexcept
        : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Hdf5Object& operator=(Hdf5Object&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }

    [[nodiscard]] hid_t id() const { return id_; }
    /// Closes the object. Returns whether that succeeded.
    [[nodiscard]] bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

private:
    hid_t id_;
    Close close_;
};

/// A call of the library that failed.
struct Hdf5Failure {};

/// Rows in datasets of one dimension, with the first column as its scale: see "HDF5 Dimension Scale
/// Specification and Design Notes". Readers of netCDF-4 therefore take them for variables over `t`.
/// A file depends only on its contents, and on no clock.
class Hdf5Rows : public RowFile {
public:
    Hdf5Rows(const std::filesystem::path& path, const TableHead& head);
    void row(const std::vector<double>& values) override;
    [[nodiscard]] bool good() const override { return good_; }
    /// NOTE: a file that is not closed cannot be read.
    [[nodiscard]] std::int64_t flushed_size() override { return -1; }
    [[nodiscard]] bool close() override;

private:
    void begin(const TableHead& head);
    void add_column(const NamedColumn& column, const Hdf5Object& creation,
                    const Hdf5Object& access);
    void attach_columns();
    void flush();

    std::size_t in_chunk_;  ///< rows in a chunk
    bool good_ = true;
    std::optional<Hdf5Object> file_;
    std::vector<Hdf5Object> columns_;  ///< datasets; below the file, so that they are closed first
    std::vector<TableNumbers> numbers_;        ///< types of their numbers
    std::vector<std::vector<double>> buffer_;  ///< rows that are not written yet, column by column
    hsize_t written_ = 0;                      ///< written rows
};

/// Adds a text to a whole file. Returns false where it cannot be written.
[[nodiscard]] bool add_note(const std::filesystem::path& path, const std::string& name,
                            const std::string& text);

}  // namespace hvi::gen
