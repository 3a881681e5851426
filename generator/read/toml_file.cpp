// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/toml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/read/file.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

/// Returns the byte at which a column of toml++ starts; it counts Unicode characters from 1.
std::size_t byte_of_column(std::string_view line, toml::source_index column) {
    const auto starts_character = [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
    };
    toml::source_index seen = 0;
    for (std::size_t byte = 0; byte < line.size(); ++byte)
        if (starts_character(line[byte]) && ++seen == column) return byte;
    return line.size();
}

/// Returns a possible cure for a line that is no TOML. NOTE: keys beside ASCII need quotes in TOML,
/// and are no names even so.
std::string help_for_line(std::string_view line) {
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) return "";
    const std::string_view key = line.substr(0, sign);
    const Range value = trimmed(line, {sign + 1, line.size()});
    if (std::any_of(key.begin(), key.end(), [](char c) { return (c & 0x80) != 0; }))
        return "names are made of the letters a to z and A to Z, digits and `_`";
    const bool is_bare =
        value.begin < value.end &&
        std::string_view("\"'[{").find(line[value.begin]) == std::string_view::npos;
    if (!is_bare) return "";
    const std::string_view text = line.substr(value.begin, value.end - value.begin);
    const bool is_decimal = text.find_first_not_of("+-0123456789,") == std::string_view::npos;
    return is_decimal ? "a decimal number has a point: `0.5`"
                      : "formulas stand in quotes, as in phi = \"pi/4\"";
}

}  // namespace

Source toml_source(const std::filesystem::path& path) {
    constexpr std::size_t largest_file = 1024 * 1024;
    return {path.string(), read_file(path, largest_file)};
}

TomlFile::TomlFile(const Source& file) : file_(file) {
    try {
        table_ = toml::parse(std::string_view(file.text));
    } catch (const toml::parse_error& error) {
        const Place at = place(error.source());
        throw InputError(fmt::format("this is no TOML: {}", error.description()), at,
                         help_for_line(at.source->text));
    }
}

std::size_t TomlFile::begin_of_line(toml::source_index number) const {
    std::size_t begin = 0;
    for (; number > 1 && begin < file_.text.size(); --number)
        begin = std::min(file_.text.find('\n', begin), file_.text.size() - 1) + 1;
    return begin;
}

std::string TomlFile::line(toml::source_index number) const {
    const std::size_t begin = begin_of_line(number);
    return file_.text.substr(begin, file_.text.find('\n', begin) - begin);
}

Place TomlFile::place(const toml::source_region& region) const {
    std::string text = line(region.begin.line);
    const std::size_t begin = byte_of_column(text, region.begin.column);
    const std::size_t end = region.end.line == region.begin.line
                                ? byte_of_column(text, region.end.column)
                                : text.size();
    const auto source = std::make_shared<const Source>(
        Source{fmt::format("{}:{}", file_.name, region.begin.line), std::move(text)});
    return {source, {begin, std::max(begin, end)}};
}

std::shared_ptr<const Source> TomlFile::source(const toml::node& node, std::string text) const {
    toml::source_position at = node.source().begin;
    if (text.find('\n') != std::string::npos) {
        constexpr std::size_t quotes = 3;
        std::size_t begin =
            begin_of_line(at.line) + byte_of_column(line(at.line), at.column) + quotes;
        if (file_.text.substr(std::min(begin, file_.text.size()), 1) == "\n") {
            ++begin;
            ++at.line;
        }
        const bool as_it_stands =
            begin < file_.text.size() && file_.text.compare(begin, text.size(), text) == 0;
        if (!as_it_stands) std::replace(text.begin(), text.end(), '\n', ' ');
    }
    return std::make_shared<const Source>(
        Source{fmt::format("{}:{}", file_.name, at.line), std::move(text)});
}

std::string TomlFile::text(const toml::node& node) const {
    if (const auto* string = node.as_string()) return string->get();
    if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
    if (node.is_floating_point()) return written_number(node);
    throw InputError("a text or a number is wanted here", place(node), "write for example \"1/2\"");
}

std::string TomlFile::written_number(const toml::node& node) const {
    const Place number = place(node);
    std::string text =
        number.source->text.substr(number.range.begin, number.range.end - number.range.begin);
    text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
    if (text.find_first_not_of("0123456789+-.eE") != std::string::npos)
        throw InputError(fmt::format("`{}` is not a finite number", text), number);
    return text;
}

void TomlFile::check_keys(const toml::table& table, std::string_view what,
                          const std::vector<std::string_view>& known) const {
    for (const auto& [key, node] : table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        throw InputError(
            fmt::format("a {} has no key `{}`", what, key.str()), place(key.source()),
            did_you_mean(key.str(), known, fmt::format("the keys are {}", listed(known))));
    }
}

std::string TomlFile::name() const {
    const toml::node* node = table_.get("name");
    if (node == nullptr) return {};
    const auto* string = node->as_string();
    if (string == nullptr) throw InputError("the name is not a text", place(*node));
    const std::string& name = string->get();
    const bool plain =
        !name.empty() && name.size() <= 64 && name.front() != ' ' && name.back() != ' ' &&
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                               "-_:.+ ") == std::string::npos;
    if (!plain)
        throw InputError("this cannot be a name", place(*node),
                         "a name has 1 to 64 letters, digits, blanks and characters of -_:.+");
    return name;
}

std::vector<TomlEntry> in_order(const toml::table& table) {
    std::vector<TomlEntry> entries;
    for (const auto& [key, node] : table) entries.emplace_back(&key, &node);
    std::sort(entries.begin(), entries.end(), [](const TomlEntry& left, const TomlEntry& right) {
        return left.first->source().begin < right.first->source().begin;
    });
    return entries;
}

}  // namespace hvi::gen
