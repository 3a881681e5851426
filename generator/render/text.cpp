// A tableau for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "generator/render/entry.hpp"
#include "generator/render/layout.hpp"
#include "generator/render/render.hpp"
#include "generator/render/text_parts.hpp"

namespace hvi::gen {

namespace {

/// The two tableaux in one form, exact or decimal.
struct Shown {
    std::vector<std::string> c;
    Cells A;
    std::vector<std::string> c_tilde;
    Cells A_tilde;
    std::vector<std::string> b;
};

template <class Form>
Shown shown(const ButcherPair& pair, Form&& form) {
    const auto vector = [&](const NumberVector& numbers) {
        std::vector<std::string> texts;
        for (const Number& number : numbers) texts.push_back(form(number));
        return texts;
    };
    const auto matrix = [&](const NumberMatrix& rows) {
        Cells cells;
        for (const NumberVector& row : rows) cells.push_back(vector(row));
        return cells;
    };
    return {vector(pair.c), matrix(pair.A), vector(pair.c_tilde), matrix(pair.A_tilde),
            vector(pair.b)};
}

std::string entry_by_entry(const Shown& shown) {
    return vector_entries("c", shown.c) + vector_entries("b", shown.b) +
           matrix_entries("A", shown.A) + vector_entries("c~", shown.c_tilde) +
           matrix_entries("A~", shown.A_tilde);
}

/// Returns the two tableaux as tables, ending in an empty line; nothing when the terminal has no
/// room.
std::optional<std::string> as_tables(const Shown& shown) {
    const Lines left = table_lines({"c", "A", shown.c, shown.A, "b", shown.b});
    const Lines right = table_lines({"c~", "A~", shown.c_tilde, shown.A_tilde, "b", shown.b});
    const Lines both = beside(left, right);
    std::string text;
    if (width(both) <= terminal_columns) {
        append(text, both);
        return text + "\n";
    }
    if (width(left) > terminal_columns || width(right) > terminal_columns) return {};
    append(text, left);
    text += "\n";
    append(text, right);
    return text + "\n";
}

/// Returns the exact forms, with decimals where there is no closed form.
std::string exact_part(const ButcherPair& pair, int digits) {
    bool exact = false;
    bool complete = true;
    const Shown entries = shown(pair, [&](const Number& number) {
        const Entry entry = make_entry(number, digits);
        exact = exact || entry.exact;
        complete = complete && entry.exact;
        return entry.best_text();
    });
    if (!exact) return {};
    const std::string note = complete ? "" : "a decimal stands where there is no closed form\n\n";
    const auto tables = as_tables(entries);
    return note + (tables ? *tables : entry_by_entry(entries));
}

/// Returns the decimals. They are in tables where these fit with all digits. Where they do not fit,
/// up to `easily_read` digits are cut down to `fewest_digits` for tables; who asks for more digits
/// wants them all.
std::string decimal_part(const ButcherPair& pair, int digits) {
    constexpr int easily_read = 16;
    constexpr int fewest_digits = 10;
    constexpr std::size_t narrowest_column = fewest_digits + 4;
    const auto with_digits = [&](int count) {
        return shown(pair, [&](const Number& number) { return number.decimal(count); });
    };
    const bool room = (pair.stages() + 1) * narrowest_column <= terminal_columns;
    const int fewest = digits <= easily_read ? std::min(digits, fewest_digits) : digits;
    for (int count = digits; room && count >= fewest; --count)
        if (const auto tables = as_tables(with_digits(count)))
            return fmt::format("to {} digits\n\n{}", count, *tables);
    return fmt::format("to {} digits\n\n{}", digits, entry_by_entry(with_digits(digits)));
}

}  // namespace

std::string render_text(const Tableau& tableau, int digits) {
    std::string text = heading(tableau.provenance, tableau.parameters,
                               fmt::format("stages      {}\n", tableau.stages()));
    text += exact_part(tableau, digits);
    if (tableau.parameters.empty()) text += decimal_part(tableau, digits);
    text.pop_back();
    return text;
}

}  // namespace hvi::gen
