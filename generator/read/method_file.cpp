// Method files. toml++ reads the TOML; numbers are taken from the text as they are written, since
// 0.1 as a double is not 1/10.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include <toml++/toml.h>

#include "generator/read/catalogue.hpp"
#include "generator/read/check.hpp"
#include "generator/read/file.hpp"
#include "generator/read/method.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t largest_file = 1024 * 1024;

/// The byte at which a column of toml++ starts; it counts Unicode characters from 1.
std::size_t byte_of_column(std::string_view line, toml::source_index column) {
    const auto starts_character = [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
    };
    toml::source_index seen = 0;
    for (std::size_t byte = 0; byte < line.size(); ++byte)
        if (starts_character(line[byte]) && ++seen == column) return byte;
    return line.size();
}

/// A TOML text that can say where in it something stands.
class TomlFile {
public:
    explicit TomlFile(const Source& file);

    [[nodiscard]] const toml::table& table() const { return table_; }
    [[nodiscard]] Place place(const toml::source_region& region) const;
    [[nodiscard]] Place place(const toml::node& node) const { return place(node.source()); }

    /// A text that stands in the file, under the name `FILE:LINE`.
    [[nodiscard]] std::shared_ptr<const Source> source(const toml::node& node,
                                                       std::string text) const;

    /// A string, or a number as it is written. Throws InputError for anything else.
    [[nodiscard]] std::string text(const toml::node& node) const;

private:
    [[nodiscard]] std::string line(toml::source_index number) const;
    [[nodiscard]] std::string written_number(const toml::node& node) const;

    const Source& file_;
    toml::table table_;
};

TomlFile::TomlFile(const Source& file) : file_(file) {
    try {
        table_ = toml::parse(std::string_view(file.text));
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("this is no TOML: {}", error.description()),
                         place(error.source()));
    }
}

std::string TomlFile::line(toml::source_index number) const {
    std::size_t begin = 0;
    for (; number > 1 && begin < file_.text.size(); --number)
        begin = std::min(file_.text.find('\n', begin), file_.text.size() - 1) + 1;
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
    return std::make_shared<const Source>(
        Source{fmt::format("{}:{}", file_.name, node.source().begin.line), std::move(text)});
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

void check_keys(const TomlFile& file) {
    static const std::vector<std::string_view> known{"name", "basis", "nodes", "weights",
                                                     "parameters"};
    for (const auto& [key, node] : file.table()) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        throw InputError(
            fmt::format("a method file has no key `{}`", key.str()), file.place(key.source()),
            did_you_mean(key.str(), known, fmt::format("the keys are {}", fmt::join(known, ", "))));
    }
}

/// The name goes into comments, class names and titles, so it stays plain.
std::string method_name(const TomlFile& file) {
    const toml::node* node = file.table().get("name");
    if (node == nullptr) return {};
    const auto* string = node->as_string();
    if (string == nullptr) throw InputError("the name is not a text", file.place(*node));
    const std::string& name = string->get();
    const bool plain =
        !name.empty() && name.size() <= 64 && name.front() != ' ' && name.back() != ' ' &&
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                               "-_:.+ ") == std::string::npos;
    if (!plain)
        throw InputError("this cannot be the name of a method", file.place(*node),
                         "a name has 1 to 64 letters, digits, blanks and characters of -_:.+");
    return name;
}

/// An array of texts, joined to one list. Each is read alone first, so that an error speaks of its
/// own line, and no parenthesis spans two of them.
List joined_list(const TomlFile& file, const toml::array& array) {
    if (array.empty()) throw InputError("the list is empty", file.place(array));
    if (array.size() > static_cast<std::size_t>(largest_size))
        throw InputError(fmt::format("the list has more than {} entries", largest_size),
                         file.place(array));
    std::string joined;
    for (const toml::node& element : array) {
        std::string text = file.text(element);
        (void)parse_list(file.source(element, text));
        joined += (joined.empty() ? "" : ", ") + text;
    }
    return parse_list(file.source(array, std::move(joined)));
}

std::optional<List> find_list(const TomlFile& file, std::string_view key) {
    const toml::node* node = file.table().get(key);
    if (node == nullptr) return {};
    if (const auto* array = node->as_array()) return joined_list(file, *array);
    return parse_list(file.source(*node, file.text(*node)));
}

List required_list(const TomlFile& file, const Source& whole, std::string_view key) {
    if (std::optional<List> list = find_list(file, key)) return std::move(*list);
    const auto name = std::make_shared<const Source>(Source{"file", whole.name});
    throw InputError(
        fmt::format("the method file has no `{}`", key), Place{name, {0, name->text.size()}},
        fmt::format("add a line such as {}",
                    key == "basis" ? "basis = \"1, cos(pi*tau)\"" : "nodes = \"0, 1\""));
}

void set_parameters(const TomlFile& file, Method& method) {
    const toml::node* node = file.table().get("parameters");
    if (node == nullptr) return;
    const auto* table = node->as_table();
    if (table == nullptr)
        throw InputError("the parameters are not a table", file.place(*node),
                         "write a section [parameters] with lines such as w = 2");
    for (const auto& [key, value] : *table) {
        Parameter parameter{std::string(key.str()), {}, file.place(key.source())};
        check_parameter_name(parameter.name, parameter.place);
        const auto source = file.source(value, file.text(value));
        parameter.value = parse_expression(source);
        check_parameter_value(parameter.value, {source, {0, source->text.size()}});
        set_parameter(method, std::move(parameter));
    }
}

}  // namespace

Method method_from_toml(const Source& source) {
    const TomlFile file(source);
    check_keys(file);
    const std::string name = method_name(file);
    List basis = required_list(file, source, "basis");
    List nodes = required_list(file, source, "nodes");
    Method method =
        method_from_lists(std::move(basis), std::move(nodes), find_list(file, "weights"));
    method.name = name;
    set_parameters(file, method);
    method.origin = "--method-file " + quoted_file_name(source.name);
    return method;
}

Method method_from_file(const std::filesystem::path& path) {
    return method_from_toml({path.string(), read_file(path, largest_file)});
}

}  // namespace hvi::gen
