// The table of reserved names.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/expr/functions.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

struct Reserved {
    std::string_view name;
    std::string_view meaning;
    std::string_view instead;
};

constexpr std::array<Reserved, 5> reserved_names{{
    {"pi", "the number pi", "pi_value"},
    {"e", "the number e", "ecc"},
    {"tau", "the variable of basis functions", "tau_value"},
    {"t", "the time", "time"},
    {"h", "the step size", "height"},
}};

const Reserved* find_reserved(std::string_view name) {
    const auto* found = std::find_if(reserved_names.begin(), reserved_names.end(),
                                     [&](const Reserved& entry) { return entry.name == name; });
    return found == reserved_names.end() ? nullptr : found;
}

bool is_name(const std::string& text) {
    return !text.empty() && is_name_start(text.front()) && text.front() != '_' &&
           std::all_of(text.begin(), text.end(), is_name_char);
}

/// Whether the text is a whole number of at most 7 digits, as the reader writes it.
bool is_whole_number(std::string_view text) {
    if (text.substr(0, 1) == "-" && text != "-0") text.remove_prefix(1);
    const bool short_number =
        !text.empty() && text.size() <= 7 && std::all_of(text.begin(), text.end(), is_digit);
    return short_number && (text == "0" || text.front() != '0');
}

}  // namespace

bool is_indexed_name(const std::string& name) {
    const std::size_t bracket = name.find('[');
    if (bracket == std::string::npos || name.back() != ']') return false;
    std::string_view indices = std::string_view(name).substr(bracket + 1);
    indices.remove_suffix(1);
    for (;;) {
        const std::size_t comma = indices.find(',');
        if (!is_whole_number(indices.substr(0, comma))) return false;
        if (comma == std::string_view::npos) return true;
        indices.remove_prefix(comma + 1);
    }
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_constant(std::string_view name) { return name == "pi" || name == "e"; }

std::string_view without_index(std::string_view name) { return name.substr(0, name.find('[')); }

bool is_reserved(std::string_view indexed) {
    const std::string_view name = without_index(indexed);
    return find_reserved(name) != nullptr || is_function(name);
}

void check_parameter_name(const std::string& name, const Place& place, std::string_view subject) {
    if (!is_name(name))
        throw InputError(fmt::format("`{}` is no name for {}", name, subject), place,
                         "a name is a letter followed by letters, digits and `_`");
    if (const Reserved* reserved = find_reserved(name))
        throw InputError(fmt::format("`{}` is reserved: it is {}", name, reserved->meaning), place,
                         fmt::format("take another name, such as `{}`", reserved->instead));
    if (is_function(name))
        throw InputError(fmt::format("`{}` is reserved: it is a function", name), place,
                         fmt::format("take another name, such as `{}_value`", name));
}

void check_symbol_name(const std::string& name, const Place& place, std::string_view subject) {
    check_parameter_name(is_indexed_name(name) ? std::string(without_index(name)) : name, place,
                         subject);
}

void walk(const Expression& expression, const std::function<bool(const Expression&)>& visit) {
    if (!visit(expression)) return;
    for (const Expression& argument : expression.arguments) walk(argument, visit);
}

void insert_parameters(const Expression& expression, std::set<std::string>& names) {
    walk(expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol && !is_reserved(part.name))
            names.insert(part.name);
        return true;
    });
}

}  // namespace hvi::gen
