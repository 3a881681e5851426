// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/column_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <string_view>
#include <system_error>
#include <utility>

#include "generator/read/csv_lines.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/npy_head.hpp"
#include "generator/read/number_file.hpp"
#include "generator/read/token.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Returns the file as readers of its formats take it.
NumberFile number_file(const ColumnFile& file) { return {file.directory / file.path, file.place}; }

// ---- CSV ----

std::size_t column_number(const ColumnFile& file, std::string_view head) {
    if (!file.column)
        refuse(number_file(file), "of which column?", "write {file = \"...\", column = \"...\"}");
    std::vector<std::string_view> names;
    for (const Range cell : cells(head))
        names.push_back(head.substr(cell.begin, cell.end - cell.begin));
    const auto found = std::find(names.begin(), names.end(), *file.column);
    if (found == names.end())
        refuse(number_file(file), fmt::format("there is no column `{}`", *file.column),
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

std::variant<ValueList, ValueFile> values_of_csv(const ColumnFile& file, std::ifstream stream,
                                                 std::size_t most) {
    CsvLines lines(number_file(file), std::move(stream));
    if (!lines.next()) refuse(number_file(file), "the file is empty");
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

std::variant<ValueList, ValueFile> values_of_npy(const ColumnFile& file, std::ifstream stream,
                                                 std::size_t most) {
    const NumberFile named = number_file(file);
    if (file.column) refuse(named, "an NPY file has no columns");
    NpyHead head = npy_head(named, stream);
    if (head.has_names)
        refuse(named, "this array has columns", "numpy.save(file, x['NAME']) saves one of them");
    ValueList list{{}, head.extents};
    std::string bytes(head.size, '\0');
    for (std::size_t k = 0; k < head.count; ++k) {
        stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        const auto value = npy_value(head.fields.front().type, bytes.data());
        const auto text = [&] {
            return std::visit([](auto x) { return fmt::format("{}", x); }, value);
        };
        const double number = std::visit([](auto x) { return static_cast<double>(x); }, value);
        if (!std::isfinite(number))
            refuse(named, fmt::format("`{}` is not a finite number", text()));
        if (head.count > most) continue;
        const auto source = std::make_shared<const Source>(
            Source{fmt::format("{}: value {}", named.path.string(), k + 1), text()});
        list.values.push_back({parse_expression(source), source});
    }
    if (head.count > most) return ValueFile{file.path, {}, std::move(head.extents)};
    return list;
}

/// Reads the values of a column where they are at most `most`, else leaves them in the file.
std::variant<ValueList, ValueFile> values_in(const ColumnFile& file, std::size_t most) {
    const Progress::Stage stage("reading files of numbers");
    std::ifstream stream = opened(number_file(file), "its path is relative to that of the scene");
    std::string begin(npy_magic.size(), '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    const bool is_npy = begin == npy_magic;
    stream.clear();
    stream.seekg(0);
    return is_npy ? values_of_npy(file, std::move(stream), most)
                  : values_of_csv(file, std::move(stream), most);
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
