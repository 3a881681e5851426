// Numbers in files: columns of CSV, and arrays of numpy.save.
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace hvi::detail {

/// Name of a column, and the vector that its numbers go to.
template <class Scalar>
struct Column {
    std::string_view name;
    std::vector<Scalar>* numbers;
};

[[noreturn]] inline void refuse_file(const std::filesystem::path& path, const std::string& fault) {
    throw std::runtime_error(path.string() + ": " + fault);
}

/// Returns the text without blanks at its ends.
[[nodiscard]] inline std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) { return {}; }
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Rows of a CSV file. Blank lines and lines that begin with # do not count. The first row has the
/// names of the columns.
class CsvRows {
public:
    explicit CsvRows(const std::filesystem::path& path) : path_(path), stream_(path) {
        if (!stream_) { refuse_file(path, "the file cannot be read"); }
    }

    /// Goes to the next row. Returns false where there is none.
    [[nodiscard]] bool next() {
        while (std::getline(stream_, line_)) {
            ++number_;
            const std::string_view text = without_blanks(line_);
            if (!text.empty() && text.front() != '#') { return true; }
        }
        return false;
    }

    /// Calls see(cell, number) for each cell between commas.
    template <class See>
    void for_each_cell(See see) const {
        std::string_view rest = line_;
        for (std::size_t cell = 0;; ++cell) {
            const std::size_t comma = rest.find(',');
            see(without_blanks(rest.substr(0, comma)), cell);
            if (comma == std::string_view::npos) { return; }
            rest.remove_prefix(comma + 1);
        }
    }

    [[noreturn]] void refuse(const std::string& fault) const {
        refuse_file(path_, "line " + std::to_string(number_) + ": " + fault);
    }

private:
    std::filesystem::path path_;
    std::ifstream stream_;
    std::string line_;
    std::size_t number_ = 0;
};

template <class Scalar>
[[nodiscard]] Scalar number_in(std::string_view text, const CsvRows& row) {
    Scalar value{};
    const char* const last = text.data() + text.size();
    const auto result = std::from_chars(text.data(), last, value);
    if (result.ec != std::errc{} || result.ptr != last || !std::isfinite(value)) {
        row.refuse("`" + std::string(text) + "` is not a finite number");
    }
    return value;
}

template <class Scalar>
void read_csv(const std::filesystem::path& path, const std::vector<Column<Scalar>>& columns) {
    CsvRows rows(path);
    if (!rows.next()) { refuse_file(path, "the file is empty"); }
    std::vector<std::vector<std::vector<Scalar>*>> of_cell;  // vectors that take it
    std::size_t found = 0;
    rows.for_each_cell([&](std::string_view name, std::size_t) {
        of_cell.emplace_back();
        for (const Column<Scalar>& column : columns) {
            if (column.name != name) { continue; }
            of_cell.back().push_back(column.numbers);
            ++found;
        }
    });
    if (found != columns.size()) { refuse_file(path, "a column is missing, or there twice"); }
    for (const Column<Scalar>& column : columns) { column.numbers->clear(); }
    while (rows.next()) {
        std::size_t count = 0;
        rows.for_each_cell([&](std::string_view text, std::size_t cell) {
            ++count;
            if (cell >= of_cell.size() || of_cell[cell].empty()) { return; }
            const Scalar value = number_in<Scalar>(text, rows);
            for (std::vector<Scalar>* numbers : of_cell[cell]) { numbers->push_back(value); }
        });
        if (count != of_cell.size()) {
            rows.refuse("it has not as many values as there are names");
        }
    }
}

/// Reads numbers of the type Number, as they stand in memory, up to the end of the file.
template <class Number, class Scalar>
void read_numbers(const std::filesystem::path& path, std::ifstream& stream,
                  std::vector<Scalar>& numbers) {
    std::vector<Number> block(4096);
    numbers.clear();
    while (stream) {
        stream.read(reinterpret_cast<char*>(block.data()),
                    static_cast<std::streamsize>(block.size() * sizeof(Number)));
        const std::size_t count = static_cast<std::size_t>(stream.gcount()) / sizeof(Number);
        for (std::size_t i = 0; i < count; ++i) {
            const Scalar value = static_cast<Scalar>(block[i]);
            if (!std::isfinite(value)) { refuse_file(path, "a number is not finite"); }
            numbers.push_back(value);
        }
    }
}

/// Reads an array of numpy.save. NOTE: of the dictionary in the header only the type is looked at.
template <class Scalar>
void read_npy(const std::filesystem::path& path, std::ifstream& stream,
              std::vector<Scalar>& numbers) {
    const auto byte = [&] {
        const int read = stream.get();
        if (read < 0) { refuse_file(path, "this is no NPY file"); }
        return static_cast<std::size_t>(read);
    };
    const std::size_t major = byte();
    static_cast<void>(byte());
    std::size_t length = 0;
    for (unsigned i = 0; i < (major == 1 ? 2U : 4U); ++i) { length |= byte() << (8 * i); }
    std::string head;
    for (std::size_t i = 0; i < length; ++i) { head += static_cast<char>(byte()); }
    const auto has = [&](const char* type) { return head.find(type) != std::string::npos; };
    if (has("'<f8'")) { return read_numbers<double>(path, stream, numbers); }
    if (has("'<f4'")) { return read_numbers<float>(path, stream, numbers); }
    if (has("'<i8'")) { return read_numbers<std::int64_t>(path, stream, numbers); }
    if (has("'<i4'")) { return read_numbers<std::int32_t>(path, stream, numbers); }
    refuse_file(path, "the numbers of this file are in a format that is not read");
}

/// Reads columns of a file, whose path may be relative to the directory. The file is CSV, or NPY
/// with all its numbers in one column without a name. Throws std::runtime_error for a file of
/// another kind.
template <class Scalar>
void read_columns(const std::string& directory, const char* path,
                  const std::vector<Column<Scalar>>& columns) {
    const std::filesystem::path file = std::filesystem::path(directory) / path;
    std::ifstream stream(file, std::ios::binary);
    char magic[6] = {};
    if (stream.read(magic, sizeof magic) && std::memcmp(magic, "\x93NUMPY", sizeof magic) == 0) {
        for (const Column<Scalar>& column : columns) {
            stream.clear();
            stream.seekg(sizeof magic);
            read_npy(file, stream, *column.numbers);
        }
        return;
    }
    read_csv(file, columns);
}

}  // namespace hvi::detail
