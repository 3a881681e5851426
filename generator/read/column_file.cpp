// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/column_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <string_view>
#include <system_error>
#include <utility>

#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

[[noreturn]] void refuse(const ColumnFile& file, const std::string& fault, std::string help = {}) {
    throw InputError(
        fmt::format("{}: {}", std::filesystem::path(file.path).filename().string(), fault),
        file.place, std::move(help));
}

std::ifstream opened(const ColumnFile& file) {
    std::ifstream stream(file.directory / file.path, std::ios::binary);
    if (!stream) refuse(file, "the file cannot be read");
    return stream;
}

// ---- CSV ----

/// The lines of a CSV file that count, one after the other.
class CsvLines {
public:
    explicit CsvLines(const ColumnFile& file)
        : file_(file), stream_(opened(file)), line_(longest + 1, '\0') {}

    /// Moves to the next line; false at the end of the file.
    [[nodiscard]] bool next() {
        while (stream_.getline(line_.data(), static_cast<std::streamsize>(line_.size()))) {
            ++number_;
            const auto read = static_cast<std::size_t>(stream_.gcount());
            text_ = std::string_view(line_).substr(0, read - (stream_.eof() ? 0 : 1));
            const Range content = trimmed(text_, {0, text_.size()});
            if (content.begin != content.end && text_[content.begin] != '#') return true;
        }
        if (!stream_.eof()) refuse(file_, "a line is longer than those of tables of numbers are");
        return false;
    }

    [[nodiscard]] std::string_view text() const { return text_; }

    /// Returns the line as a source with its number in the name.
    [[nodiscard]] std::shared_ptr<const Source> source() const {
        return std::make_shared<const Source>(
            Source{fmt::format("{}:{}", (file_.directory / file_.path).string(), number_),
                   std::string(text_)});
    }

private:
    static constexpr std::size_t longest = 1024 * 1024;

    const ColumnFile& file_;
    std::ifstream stream_;
    std::string line_;
    std::string_view text_;
    std::size_t number_ = 0;
};

/// Returns the ranges of the cells between commas.
std::vector<Range> cells(std::string_view line) {
    std::vector<Range> result;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t comma = std::min(line.find(',', begin), line.size());
        result.push_back(trimmed(line, {begin, comma}));
        if (comma == line.size()) return result;
        begin = comma + 1;
    }
}

std::size_t column_number(const ColumnFile& file, std::string_view head) {
    if (!file.column) refuse(file, "of which column?", "write {file = \"...\", column = \"...\"}");
    std::vector<std::string_view> names;
    for (const Range cell : cells(head))
        names.push_back(head.substr(cell.begin, cell.end - cell.begin));
    const auto found = std::find(names.begin(), names.end(), *file.column);
    if (found == names.end())
        refuse(file, fmt::format("there is no column `{}`", *file.column),
               did_you_mean(*file.column, names, fmt::format("the columns are {}", listed(names))));
    return static_cast<std::size_t>(found - names.begin());
}

/// NOTE: generated programs read these files with the same function.
bool is_number(std::string_view line, Range cell) {
    double value = 0;
    const char* const last = line.data() + cell.end;
    const auto [end, error] = std::from_chars(line.data() + cell.begin, last, value);
    return error == std::errc{} && end == last && std::isfinite(value);
}

void check_number(const std::shared_ptr<const Source>& source, Range cell) {
    if (is_number(source->text, cell)) return;
    throw InputError(
        fmt::format("`{}` is not a finite number",
                    source->text.substr(cell.begin, cell.end - cell.begin)),
        Place{source, cell},
        fmt::format("a column of more than {} values has numbers alone", most_values_in_text));
}

std::variant<ValueList, ValueFile> values_of_csv(const ColumnFile& file, std::size_t most) {
    CsvLines lines(file);
    if (!lines.next()) refuse(file, "the file is empty");
    const std::size_t column = column_number(file, lines.text());
    const std::size_t width = cells(lines.text()).size();
    std::size_t count = 0;
    std::vector<std::pair<std::shared_ptr<const Source>, Range>> first;
    while (lines.next()) {
        const std::vector<Range> row = cells(lines.text());
        if (row.size() != width)
            throw InputError(fmt::format("this row has {} values, and the first line {} names",
                                         row.size(), width),
                             whole(lines.source()));
        if (count++ < most)
            first.emplace_back(lines.source(), row[column]);
        else if (!is_number(lines.text(), row[column]))
            check_number(lines.source(), row[column]);
    }
    if (count > most) {
        for (const auto& [source, cell] : first) check_number(source, cell);
        return ValueFile{file.path, file.column, {count}};
    }
    ValueList list{{}, {count}};
    for (const auto& [source, cell] : first)
        list.values.push_back({parse_expression(source, cell), source});
    return list;
}

// ---- NPY ----

constexpr std::string_view npy_magic = "\x93NUMPY";

/// Returns the text behind a key of the dictionary at the beginning of an NPY file.
std::string_view behind_key(const ColumnFile& file, std::string_view head, std::string_view key) {
    const std::size_t at = head.find(key);
    if (at == std::string_view::npos) refuse(file, "this is no NPY file");
    head.remove_prefix(at + key.size());
    return head.substr(std::min(head.find_first_not_of(": "), head.size()));
}

/// Reads `(3, 4)`, or `(3,)`.
std::vector<std::size_t> shape(const ColumnFile& file, std::string_view text) {
    std::vector<std::size_t> extents;
    for (std::size_t i = 1; i < text.size() && text[i] != ')'; ++i) {
        std::size_t extent = 0;
        const std::size_t begin = i;
        while (i < text.size() && is_digit(text[i]) && i - begin < 10)
            extent = 10 * extent + static_cast<std::size_t>(text[i++] - '0');
        if (i > begin) extents.push_back(extent);
        if (i >= text.size() || text[i] == ')') break;
        if (text[i] != ',' && text[i] != ' ') refuse(file, "this is no shape of an array");
    }
    return extents;
}

template <class T>
std::string number(const ColumnFile& file, const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    if (!std::isfinite(static_cast<double>(value)))
        refuse(file, fmt::format("`{}` is not a finite number", value));
    return fmt::format("{}", value);
}

template <class T>
bool is_finite(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return std::isfinite(static_cast<double>(value));
}

struct NumberType {
    std::string_view name;
    std::size_t size;
    std::string (*text)(const ColumnFile&, const char* bytes);
    bool (*is_finite)(const char* bytes);
};

constexpr NumberType number_types[]{{"'<f8'", 8, number<double>, is_finite<double>},
                                    {"'<f4'", 4, number<float>, is_finite<float>},
                                    {"'<i8'", 8, number<std::int64_t>, is_finite<std::int64_t>},
                                    {"'<i4'", 4, number<std::int32_t>, is_finite<std::int32_t>}};

/// Returns the dictionary, and the number of bytes up to its end. Behind the magic there are two
/// bytes of the version, and the length of the dictionary in two or four.
std::pair<std::string, std::size_t> dictionary(const ColumnFile& file, std::ifstream& stream) {
    constexpr std::size_t longest = 1024 * 1024;
    std::string begin(npy_magic.size() + 2 + 4, '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    const std::size_t digits = begin[npy_magic.size()] == 1 ? 2 : 4;
    const std::size_t at = npy_magic.size() + 2 + digits;
    if (static_cast<std::size_t>(stream.gcount()) < at) refuse(file, "this is no NPY file");
    std::size_t length = 0;
    for (std::size_t i = at; i-- > npy_magic.size() + 2;)
        length = 256 * length + static_cast<unsigned char>(begin[i]);
    std::string text(std::min(length, longest), '\0');
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(at));
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (static_cast<std::size_t>(stream.gcount()) != length) refuse(file, "this is no NPY file");
    return {std::move(text), at + length};
}

const NumberType& number_type(const ColumnFile& file, std::string_view head) {
    const std::string_view descriptor = behind_key(file, head, "'descr'");
    const auto* type =
        std::find_if(std::begin(number_types), std::end(number_types), [&](const auto& one) {
            return descriptor.substr(0, one.name.size()) == one.name;
        });
    if (type == std::end(number_types) ||
        behind_key(file, head, "'fortran_order'").substr(0, 5) != "False")
        refuse(file, "the numbers of this file are in a format that is not read",
               "save them as numpy.ascontiguousarray(x, dtype='<f8')");
    return *type;
}

std::size_t count_of(const ColumnFile& file, const std::vector<std::size_t>& extents) {
    constexpr std::size_t most = 1'000'000'000;
    std::size_t count = extents.empty() ? 0 : 1;
    for (const std::size_t extent : extents) {
        if (extent > most) refuse(file, "this is no shape of an array");
        count = std::min(count * extent, most);
    }
    return count;
}

std::variant<ValueList, ValueFile> values_of_npy(const ColumnFile& file, std::ifstream stream,
                                                 std::size_t most) {
    if (file.column) refuse(file, "an NPY file has no columns");
    const auto [head, begin] = dictionary(file, stream);
    const NumberType& type = number_type(file, head);
    ValueList list{{}, shape(file, behind_key(file, head, "'shape'"))};
    const std::size_t count = count_of(file, list.extents);
    if (count == 0 ||
        std::filesystem::file_size(file.directory / file.path) != begin + count * type.size)
        refuse(file, "the shape of the array is not that of its data");
    char bytes[8] = {};
    for (std::size_t k = 0; k < count; ++k) {
        stream.read(bytes, static_cast<std::streamsize>(type.size));
        if (!type.is_finite(bytes) || count <= most) {
            const auto source = std::make_shared<const Source>(
                Source{fmt::format("{}: value {}", (file.directory / file.path).string(), k + 1),
                       type.text(file, bytes)});
            list.values.push_back({parse_expression(source), source});
        }
    }
    if (count > most) return ValueFile{file.path, {}, std::move(list.extents)};
    return list;
}

/// Reads the values of a column where they are at most `most`, else leaves them in the file.
std::variant<ValueList, ValueFile> values_in(const ColumnFile& file, std::size_t most) {
    const Progress::Stage stage("reading files of numbers");
    if (file.path.find('\0') != std::string::npos)
        throw InputError("a path has no character with code 0", file.place);
    std::error_code ignored;
    const auto status = std::filesystem::status(file.directory / file.path, ignored);
    if (status.type() == std::filesystem::file_type::not_found)
        refuse(file, "there is no such file", "its path is relative to that of the scene");
    if (status.type() != std::filesystem::file_type::regular)
        refuse(file, "this is no regular file");
    std::ifstream stream = opened(file);
    std::string begin(npy_magic.size(), '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (begin != npy_magic) return values_of_csv(file, most);
    stream.seekg(0);
    return values_of_npy(file, std::move(stream), most);
}

}  // namespace

std::variant<ValueList, ValueFile> values_in(const ColumnFile& file) {
    return values_in(file, most_values_in_text);
}

ValueList all_values_in(const ColumnFile& file) {
    return std::get<ValueList>(values_in(file, std::numeric_limits<std::size_t>::max()));
}

std::size_t count(const ValueFile& file) {
    return std::accumulate(file.extents.begin(), file.extents.end(), std::size_t{1},
                           std::multiplies<>());
}

}  // namespace hvi::gen
