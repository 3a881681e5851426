// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/named_lines.hpp"

#include <fmt/format.h>

#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/render/entry.hpp"

namespace hvi::gen {

void NamedLines::line(std::string_view name, const std::string& text) {
    for (const std::string& line : wrapped(fmt::format("{:<{}}", name, name_columns), text)) {
        text_ += line + "\n";
    }
}

void NamedLines::title(const std::string& text) {
    for (const std::string& line : wrapped("", text)) { text_ += line + "\n"; }
}

bool is_readable(const std::string& text) {
    constexpr std::size_t most_digits = 48;
    std::size_t digits = 0;
    for (const char character : text) {
        digits = '0' <= character && character <= '9' ? digits + 1 : 0;
        if (digits > most_digits) { return false; }
    }
    return true;
}

bool is_readable(const Number& number) {
    constexpr std::size_t most_terms = 1000;
    return term_count(number) <= most_terms;
}

std::string short_decimal(const Number& number) {
    if (number.has_parameters()) { return make_entry(number, 1).best_text(); }
    std::string text = number.decimal(6);
    const bool is_plain =
        text.find('.') != std::string::npos && text.find('e') == std::string::npos;
    while (is_plain && text.back() == '0') { text.pop_back(); }
    if (text.back() == '.') { text.pop_back(); }
    return text;
}

std::string value_text(const Number& number) {
    if (number.has_parameters() && !is_readable(number)) {
        return fmt::format("{} terms, too long for a line; --format json has them",
                           term_count(number));
    }
    const Entry entry = make_entry(number, 6);
    if (!entry.exact || !entry.decimal) { return entry.best_text(); }
    const std::string exact = to_text(*entry.exact);
    if (!is_readable(exact)) { return *entry.decimal; }
    const bool is_integer = exact.find_first_not_of("-0123456789") == std::string::npos;
    return is_integer ? exact : fmt::format("{} = {}", exact, *entry.decimal);
}

std::string why_no_oscillator(const Findings& findings) {
    if (findings.within_digits) { return "only some digits are known"; }
    const std::string too_long = "the coefficients are too long";
    if (findings.parameters.empty()) { return too_long; }
    return too_long + "; a value for the parameter " + findings.parameters.front() +
           " makes them short: --param " + findings.parameters.front() + "=1";
}

std::string stage_name(const StageNode& node) {
    return fmt::format("{}_{}", node.kind == StageNode::Kind::Q ? "Q" : "P", node.index + 1);
}

}  // namespace hvi::gen
