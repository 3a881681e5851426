// A method as comma-separated values.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <string_view>

#include "generator/render/entry.hpp"
#include "generator/render/render.hpp"

namespace hvi::gen {

namespace {

/// Quotes a text where RFC 4180 wants it; returns nothing for a missing text.
std::string field(const std::optional<std::string>& text) {
    if (!text || text->find_first_of("\",\r\n") == std::string::npos) return text.value_or("");
    std::string quoted = "\"";
    for (const char c : *text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string entries(const std::vector<Part>& parts, int digits) {
    std::string text = "matrix,row,column,exact,decimal,double\n";
    for_each_entry(parts, digits,
                   [&](const Part& part, std::size_t row, std::size_t column, const Entry& entry) {
                       text += fmt::format("{},{},{},{},{},{}\n", part.name, row, column,
                                           field(entry.exact_text()), field(entry.decimal),
                                           field(entry.hex));
                   });
    return text;
}

}  // namespace

std::string render_csv(const Tableau& tableau, int digits) {
    return entries(parts(tableau), digits);
}

std::string render_csv(const GalerkinRule& rule, int digits) {
    return entries(all_parts(rule), digits);
}

}  // namespace hvi::gen
