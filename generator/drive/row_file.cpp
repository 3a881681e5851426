// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/row_file.hpp"

#include <bit>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "generator/drive/hdf5_rows.hpp"
#include "generator/drive/table.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

class CsvRows : public RowFile {
public:
    CsvRows(const char* path, const TableHead& head) : columns_(head.columns), table_(path) {
        for (const NamedColumn& column : head.columns) table_.cell(column.name);
        table_.end_row();
    }
    CsvRows(const char* path, const TableHead& head, std::int64_t size)
        : columns_(head.columns), table_(path, size) {}

    void row(const std::vector<double>& values) override {
        for (std::size_t k = 0; k < values.size(); ++k) cell(columns_[k], values[k]);
        table_.end_row();
    }
    [[nodiscard]] bool good() const override { return table_.good(); }
    [[nodiscard]] std::int64_t flushed_size() override { return table_.flushed_size(); }
    [[nodiscard]] bool close() override { return table_.close(); }

private:
    void cell(const NamedColumn& column, double value) {
        if (value >= 0 && value < static_cast<double>(column.words.size()))
            table_.cell(column.words[static_cast<std::size_t>(value)]);
        else if (column.numbers == TableNumbers::floats)
            table_.cell(nearest_float(value));
        else
            table_.cell(value);
    }

    std::vector<NamedColumn> columns_;
    NumberTable table_;
};

std::size_t size_of(const NamedColumn& column) {
    return column.numbers == TableNumbers::floats ? sizeof(float) : sizeof(double);
}

std::size_t record_size(const std::vector<NamedColumn>& columns) {
    std::size_t size = 0;
    for (const NamedColumn& column : columns) size += size_of(column);
    return size;
}

/// Returns the header of an NPY file of version 2: a description as a literal of Python, padded
/// with blanks so that its length does not depend on the number of rows.
std::string npy_header(const std::vector<NamedColumn>& columns, std::int64_t rows) {
    constexpr std::size_t longest_count = 20, alignment = 64, before = 12;
    const char order = std::endian::native == std::endian::little ? '<' : '>';
    std::string fields;
    for (const NamedColumn& column : columns) {
        fields += fields.empty() ? "('" : ", ('";
        fields += column.name + "', '" + order + 'f' + std::to_string(size_of(column)) + "')";
    }
    const std::string count = std::to_string(rows);
    std::string text = "{'descr': [" + fields + "], 'fortran_order': False, 'shape': (" + count +
                       ",), }" + std::string(longest_count - count.size(), ' ');
    text += std::string(alignment - 1 - (before + text.size()) % alignment, ' ') + "\n";
    std::string header("\x93NUMPY\x02\x00", 8);
    for (std::size_t k = 0; k < 4; ++k)
        header += static_cast<char>(static_cast<unsigned char>(text.size() >> (8 * k)));
    return header + text;
}

class NpyRows : public RowFile {
public:
    NpyRows(const char* path, const TableHead& head) : columns_(head.columns), file_(path) {
        file_.bytes(npy_header(columns_, 0));
    }
    NpyRows(const char* path, const TableHead& head, std::int64_t size)
        : columns_(head.columns), file_(path, size) {
        const auto header = static_cast<std::int64_t>(npy_header(columns_, 0).size());
        count_ = (size - header) / static_cast<std::int64_t>(record_.size());
    }

    void row(const std::vector<double>& values) override {
        char* place = record_.data();
        for (std::size_t k = 0; k < values.size(); ++k) {
            const float small = nearest_float(values[k]);
            const bool is_small = columns_[k].numbers == TableNumbers::floats;
            std::memcpy(place, is_small ? static_cast<const void*>(&small) : &values[k],
                        size_of(columns_[k]));
            place += size_of(columns_[k]);
        }
        file_.bytes(record_);
        ++count_;
    }
    [[nodiscard]] bool good() const override { return file_.good(); }
    [[nodiscard]] std::int64_t flushed_size() override { return file_.flushed_size(); }
    [[nodiscard]] bool close() override {
        file_.overwrite(npy_header(columns_, count_));
        return file_.close();
    }

private:
    std::vector<NamedColumn> columns_;
    NumberTable file_;
    std::string record_ = std::string(record_size(columns_), '\0');
    std::int64_t count_ = 0;
};

}  // namespace

std::unique_ptr<RowFile> row_file(TableFormat format, const std::filesystem::path& path,
                                  const TableHead& head, std::optional<std::int64_t> size) {
    switch (format) {
    case TableFormat::csv:
        return size ? std::make_unique<CsvRows>(path.c_str(), head, *size)
                    : std::make_unique<CsvRows>(path.c_str(), head);
    case TableFormat::npy:
        return size ? std::make_unique<NpyRows>(path.c_str(), head, *size)
                    : std::make_unique<NpyRows>(path.c_str(), head);
    case TableFormat::hdf5: HVI_CHECK(!size); return std::make_unique<Hdf5Rows>(path, head);
    }
    HVI_CHECK(false);
    return nullptr;
}

void check_format(TableFormat format) {
    if (format == TableFormat::hdf5) static_cast<void>(hdf5());
}

bool mark_incomplete(TableFormat format, const std::filesystem::path& path,
                     const std::string& why) {
    if (format == TableFormat::hdf5) return add_note(path, "incomplete", why);
    if (format == TableFormat::npy) return true;
    std::FILE* const file = std::fopen(path.c_str(), "ab");
    const bool is_written =
        file != nullptr && std::fprintf(file, "# incomplete: %s\n", why.c_str()) > 0;
    return file != nullptr && std::fclose(file) == 0 && is_written;
}

}  // namespace hvi::gen
