// Laying out text for a terminal.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/layout.hpp"

#include <algorithm>
#include <string_view>

namespace hvi::gen {

namespace {

constexpr std::string_view column_gap = "  ";
constexpr std::string_view table_gap = "     ";

std::string padded(std::string text, std::size_t columns) {
    text.resize(std::max(text.size(), columns), ' ');
    return text;
}

void strip_blanks(std::string& line) { line.erase(line.find_last_not_of(' ') + 1); }

/// Makes the cells of one column equally wide.
void align(std::vector<std::string*> column) {
    const bool signs = std::any_of(column.begin(), column.end(), [](const std::string* cell) {
        return !cell->empty() && cell->front() == '-';
    });
    std::size_t columns = 0;
    for (std::string* cell : column) {
        if (signs && cell->front() != '-') cell->insert(0, 1, ' ');
        columns = std::max(columns, cell->size());
    }
    for (std::string* cell : column) *cell = padded(std::move(*cell), columns);
}

std::string in_columns(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& cell : cells) {
        if (!line.empty()) line += column_gap;
        line += cell;
    }
    return line;
}

/// Kinds of places where a line may be broken, the best first.
enum class Break { outer_sign, sign, other, none };

Break break_before(std::string_view text, std::size_t k, int depth) {
    const char before = text[k - 1];
    const bool unary = before == '(' || before == '^' || before == ',';
    if ((text[k] == '+' || text[k] == '-') && !unary)
        return depth <= 0 ? Break::outer_sign : Break::sign;
    const bool other = text[k] == '*' || text[k] == '/' || text[k] == ' ' || before == ',';
    return other ? Break::other : Break::none;
}

/// Returns the length of a line: up to the last of the best breaks within `columns`, or else up to
/// the first break after them.
std::size_t line_length(std::string_view text, std::size_t columns) {
    if (text.size() <= columns) return text.size();
    Break best = Break::none;
    std::size_t length = text.size();
    int depth = 0;
    for (std::size_t k = 1; k < text.size(); ++k) {
        if (text[k - 1] == '(') ++depth;
        if (text[k - 1] == ')') --depth;
        if (k > columns && best != Break::none) break;
        const Break here = break_before(text, k, depth);
        if (here == Break::none || here > best) continue;
        best = here;
        length = k;
    }
    return length;
}

}  // namespace

Lines table_lines(const Table& table) {
    Table aligned = table;
    std::vector<std::string*> heads{&aligned.corner, &aligned.last_head};
    for (std::string& head : aligned.heads) heads.push_back(&head);
    align(heads);
    for (std::size_t j = 0; j < aligned.last_row.size(); ++j) {
        std::vector<std::string*> column{&aligned.last_row[j]};
        for (std::vector<std::string>& row : aligned.rows) column.push_back(&row[j]);
        align(column);
    }
    const std::string last = in_columns(aligned.last_row);
    Lines lines{" " + aligned.corner + " | " + aligned.title};
    for (std::size_t i = 0; i < aligned.rows.size(); ++i)
        lines.push_back(" " + aligned.heads[i] + " | " + in_columns(aligned.rows[i]));
    lines.push_back(std::string(aligned.corner.size() + 2, '-') + "+" +
                    std::string(last.size() + 1, '-'));
    lines.push_back(" " + aligned.last_head + " | " + last);
    std::for_each(lines.begin(), lines.end(), strip_blanks);
    return lines;
}

std::size_t width(const Lines& lines) {
    std::size_t columns = 0;
    for (const std::string& line : lines) columns = std::max(columns, line.size());
    return columns;
}

Lines beside(const Lines& left, const Lines& right) {
    const std::size_t columns = width(left);
    Lines lines;
    for (std::size_t k = 0; k < std::max(left.size(), right.size()); ++k) {
        std::string line = padded(k < left.size() ? left[k] : "", columns);
        line += table_gap;
        if (k < right.size()) line += right[k];
        strip_blanks(line);
        lines.push_back(std::move(line));
    }
    return lines;
}

Lines wrapped(const std::string& head, const std::string& text) {
    const std::size_t columns = terminal_columns - std::min(head.size(), terminal_columns / 2);
    Lines lines;
    std::string_view rest = text;
    do {
        const std::size_t length = line_length(rest, columns);
        std::string line = lines.empty() ? head : std::string(head.size(), ' ');
        line += rest.substr(0, length);
        strip_blanks(line);
        lines.push_back(std::move(line));
        rest.remove_prefix(length);
        rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    } while (!rest.empty());
    return lines;
}

}  // namespace hvi::gen
