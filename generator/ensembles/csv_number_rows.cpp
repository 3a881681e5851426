// Rows of a CSV file: read once, then found again by the places of some of its lines.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <limits>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "generator/ensembles/number_formats.hpp"
#include "generator/read/csv_lines.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr std::int64_t rows_between_places = 1024;

std::string_view part_of(std::string_view line, Range range) {
    return line.substr(range.begin, range.end - range.begin);
}

struct ParsedNumber {
    double value = std::numeric_limits<double>::quiet_NaN();
    std::errc error{};
};

ParsedNumber parsed(std::string_view cell) {
    ParsedNumber result;
    if (cell.empty()) return result;
    const char* const last = cell.data() + cell.size();
    const auto [end, error] = std::from_chars(cell.data(), last, result.value);
    result.error = error == std::errc{} && end != last ? std::errc::invalid_argument : error;
    return result;
}

double number_in(const CsvLines& lines, Range cell) {
    const std::string_view text = part_of(lines.text(), cell);
    const ParsedNumber number = parsed(text);
    if (number.error == std::errc{}) return number.value;
    const bool is_far = number.error == std::errc::result_out_of_range;
    throw InputError(
        fmt::format("`{}` is {}", text, is_far ? "beyond the range of doubles" : "no number"),
        Place{lines.source(), cell},
        is_far ? "choose other units" : "numbers are like 0.5, -2e-3, nan or inf");
}

/// Returns the ranges of the names in the first line, without quotes. NOTE: a comma in quotes does
/// not end a name.
std::vector<Range> names_in(std::string_view line) {
    std::vector<Range> result;
    std::size_t begin = 0;
    bool is_quoted = false;
    for (std::size_t at = 0; at <= line.size(); ++at) {
        const bool is_end = at == line.size();
        if (!is_end && line[at] == '"') is_quoted = !is_quoted;
        if (!is_end && (is_quoted || line[at] != ',')) continue;
        Range name = trimmed(line, {begin, at});
        const bool has_quotes =
            name.end - name.begin >= 2 && line[name.begin] == '"' && line[name.end - 1] == '"';
        if (has_quotes) name = {name.begin + 1, name.end - 1};
        result.push_back(name);
        begin = at + 1;
    }
    return result;
}

/// Reads the first line that counts.
std::vector<std::string> names_of(CsvLines& lines, const NumberFile& file) {
    if (!lines.next()) refuse(file, "the file is empty");
    std::vector<std::string> names;
    std::set<std::string_view> known;
    for (const Range range : names_in(lines.text())) {
        const std::string_view name = part_of(lines.text(), range);
        const auto refuse_name = [&](const std::string& fault, const char* help) {
            throw InputError(fault, Place{lines.source(), range}, help);
        };
        constexpr const char* help = "the first line has the names of the columns: x, px";
        if (name.empty()) refuse_name("this column has no name", help);
        if (parsed(name).error == std::errc{})
            refuse_name(fmt::format("a name is wanted here, not `{}`", name), help);
        if (!known.insert(name).second)
            refuse_name(fmt::format("two columns have the name `{}`", name), "leave one out");
        names.emplace_back(name);
    }
    return names;
}

/// Adds the numbers of a line. Throws InputError where they are not as many as names.
void read_row(const CsvLines& lines, std::size_t width, std::vector<double>& numbers) {
    const std::vector<Range> row = cells(lines.text());
    if (row.size() != width)
        throw InputError(
            fmt::format("this row has {} values, and the first line {} names", row.size(), width),
            whole(lines.source()), "a value that is not known is nan");
    for (const Range cell : row) numbers.push_back(number_in(lines, cell));
}

/// The rows of a file, and the places of those from which others are found.
struct CsvIndex {
    std::int64_t rows = 0;
    std::vector<CsvLines::Position> places;
};

/// Reads all rows. Throws InputError for the first one that is wrong.
CsvIndex index_of(CsvLines& lines, std::size_t width, const NumberFile& file) {
    CsvIndex index;
    std::vector<double> numbers;
    while (lines.next()) {
        if (index.rows++ % rows_between_places == 0) index.places.push_back(lines.position());
        numbers.clear();
        read_row(lines, width, numbers);
    }
    if (index.rows == 0) refuse(file, "there are no rows below the names");
    return index;
}

class CsvNumberRows : public NumberRows {
public:
    CsvNumberRows(NumberFile file, std::vector<std::string> names, CsvIndex index, CsvLines lines)
        : NumberRows(file, std::move(names), index.rows),
          file_(std::move(file)),
          index_(std::move(index)),
          lines_(std::move(lines)) {}

    std::vector<double> rows(std::int64_t first, std::int64_t count) override {
        HVI_CHECK(0 <= first && 0 <= count && first + count <= this->count());
        go_to(first);
        std::vector<double> numbers;
        numbers.reserve(static_cast<std::size_t>(count) * names().size());
        for (std::int64_t row = 0; row < count; ++row) {
            move();
            read_row(lines_, names().size(), numbers);
        }
        return numbers;
    }

private:
    void go_to(std::int64_t row) {
        if (row == next_ || row == count()) return;
        lines_.go_to(index_.places[static_cast<std::size_t>(row / rows_between_places)]);
        next_ = row - row % rows_between_places;
        while (next_ < row) move();
    }

    void move() {
        if (!lines_.next()) refuse_changed(file_);
        ++next_;
    }

    NumberFile file_;
    CsvIndex index_;
    CsvLines lines_;
    std::int64_t next_ = -1;  ///< the row that the next line is; none at first
};

}  // namespace

std::unique_ptr<NumberRows> csv_number_rows(const NumberFile& file, std::ifstream stream) {
    CsvLines lines(file, std::move(stream));
    std::vector<std::string> names = names_of(lines, file);
    CsvIndex index = index_of(lines, names.size(), file);
    return std::make_unique<CsvNumberRows>(file, std::move(names), std::move(index),
                                           std::move(lines));
}

}  // namespace hvi::gen
