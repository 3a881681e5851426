// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/column_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "generator/read/file.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t largest_column_file = 1024 * 1024;

[[noreturn]] void refuse(const ColumnFile& file, const std::string& fault, std::string help = {}) {
    throw InputError(fmt::format("{}: {}", file.path.filename().string(), fault), file.place,
                     std::move(help));
}

// ---- CSV ----

/// What stands between commas.
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

/// The lines that count, each with its number in its name.
std::vector<std::shared_ptr<const Source>> lines(const ColumnFile& file, std::string_view text) {
    std::vector<std::shared_ptr<const Source>> result;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const Range content = trimmed(line, {0, line.size()});
        if (content.begin == content.end || line[content.begin] == '#') continue;
        result.push_back(std::make_shared<const Source>(
            Source{fmt::format("{}:{}", file.path.string(), number), std::string(line)}));
    }
    return result;
}

std::size_t column_number(const ColumnFile& file, const Source& head) {
    if (!file.column) refuse(file, "of which column?", "write {file = \"...\", column = \"...\"}");
    std::vector<std::string_view> names;
    for (const Range cell : cells(head.text))
        names.push_back(std::string_view(head.text).substr(cell.begin, cell.end - cell.begin));
    const auto found = std::find(names.begin(), names.end(), *file.column);
    if (found == names.end())
        refuse(file, fmt::format("there is no column `{}`", *file.column),
               did_you_mean(*file.column, names,
                            fmt::format("the columns are {}", fmt::join(names, ", "))));
    return static_cast<std::size_t>(found - names.begin());
}

ValueList values_of_csv(const ColumnFile& file, std::string_view text) {
    const auto rows = lines(file, text);
    if (rows.empty()) refuse(file, "the file is empty");
    const std::size_t column = column_number(file, *rows.front());
    const std::size_t width = cells(rows.front()->text).size();
    ValueList list{{}, {rows.size() - 1}};
    for (std::size_t k = 1; k < rows.size(); ++k) {
        const std::vector<Range> row = cells(rows[k]->text);
        if (row.size() != width)
            throw InputError(fmt::format("this row has {} values, and the first line {} names",
                                         row.size(), width),
                             whole(rows[k]));
        list.values.push_back({parse_expression(rows[k], row[column]), rows[k]});
    }
    return list;
}

// ---- NPY ----

constexpr std::string_view npy_magic = "\x93NUMPY";

/// The text behind a key of the dictionary that an NPY file begins with.
std::string_view behind_key(const ColumnFile& file, std::string_view head, std::string_view key) {
    const std::size_t at = head.find(key);
    if (at == std::string_view::npos) refuse(file, "this is no NPY file");
    head.remove_prefix(at + key.size());
    return head.substr(std::min(head.find_first_not_of(": "), head.size()));
}

/// `(3, 4)`, or `(3,)`.
std::vector<std::size_t> shape(const ColumnFile& file, std::string_view text) {
    std::vector<std::size_t> extents;
    for (std::size_t i = 1; i < text.size() && text[i] != ')'; ++i) {
        std::size_t extent = 0;
        const std::size_t begin = i;
        while (i < text.size() && is_digit(text[i]) && i - begin < 7)
            extent = 10 * extent + static_cast<std::size_t>(text[i++] - '0');
        if (i > begin) extents.push_back(extent);
        if (i >= text.size() || text[i] == ')') break;
        if (text[i] != ',' && text[i] != ' ') refuse(file, "this is no shape of an array");
    }
    return extents;
}

template <class T>
std::string number(const ColumnFile& file, std::string_view bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    if (!std::isfinite(static_cast<double>(value)))
        refuse(file, fmt::format("`{}` is not a finite number", value));
    return fmt::format("{}", value);
}

struct NumberType {
    std::string_view name;
    std::size_t size;
    std::string (*text)(const ColumnFile&, std::string_view);
};

constexpr NumberType number_types[]{{"'<f8'", 8, number<double>},
                                    {"'<f4'", 4, number<float>},
                                    {"'<i8'", 8, number<std::int64_t>},
                                    {"'<i4'", 4, number<std::int32_t>}};

/// Behind the magic: two bytes of the version, and the length of the dictionary in two or four.
std::pair<std::string_view, std::string_view> head_and_data(const ColumnFile& file,
                                                            std::string_view text) {
    const std::size_t digits = text.size() > 6 && text[6] == 1 ? 2 : 4;
    const std::size_t begin = 8 + digits;
    if (text.size() < begin) refuse(file, "this is no NPY file");
    std::size_t length = 0;
    for (std::size_t i = begin; i-- > 8;)
        length = 256 * length + static_cast<unsigned char>(text[i]);
    if (length > text.size() - begin) refuse(file, "this is no NPY file");
    return {text.substr(begin, length), text.substr(begin + length)};
}

ValueList values_of_npy(const ColumnFile& file, std::string_view text) {
    if (file.column) refuse(file, "an NPY file has no columns");
    auto [head, data] = head_and_data(file, text);
    const std::string_view descriptor = behind_key(file, head, "'descr'");
    const auto* type =
        std::find_if(std::begin(number_types), std::end(number_types), [&](const auto& one) {
            return descriptor.substr(0, one.name.size()) == one.name;
        });
    if (type == std::end(number_types) ||
        behind_key(file, head, "'fortran_order'").substr(0, 5) != "False")
        refuse(file, "the numbers of this file are in a format that is not read",
               "save them as numpy.ascontiguousarray(x, dtype='<f8')");
    ValueList list{{}, shape(file, behind_key(file, head, "'shape'"))};
    std::size_t count = list.extents.empty() ? 0 : 1;
    for (const std::size_t extent : list.extents) {
        if (extent > largest_column_file) refuse(file, "this is no shape of an array");
        count = std::min(count * extent, largest_column_file);
    }
    if (count == 0 || data.size() != count * type->size)
        refuse(file, "the shape of the array is not that of its data");
    for (std::size_t k = 0; k < count; ++k) {
        const auto source = std::make_shared<const Source>(
            Source{fmt::format("{}: value {}", file.path.string(), k + 1),
                   type->text(file, data.substr(k * type->size, type->size))});
        list.values.push_back({parse_expression(source), source});
    }
    return list;
}

}  // namespace

ValueList values_in(const ColumnFile& file) {
    std::error_code ignored;
    const auto status = std::filesystem::status(file.path, ignored);
    if (status.type() == std::filesystem::file_type::not_found)
        refuse(file, "there is no such file", "its path is relative to that of the scene");
    if (status.type() != std::filesystem::file_type::regular)
        refuse(file, "this is no regular file");
    const std::string text = read_file(file.path, largest_column_file);
    const bool is_npy = std::string_view(text).substr(0, npy_magic.size()) == npy_magic;
    return is_npy ? values_of_npy(file, text) : values_of_csv(file, text);
}

}  // namespace hvi::gen
