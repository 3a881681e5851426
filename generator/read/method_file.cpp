// Method files.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "generator/read/catalogue.hpp"
#include "generator/read/check.hpp"
#include "generator/read/file.hpp"
#include "generator/read/method.hpp"
#include "generator/read/names.hpp"
#include "generator/read/toml_file.hpp"

namespace hvi::gen {

namespace {

/// Joins an array of texts to one list. Each text is read alone first, so that an error speaks of
/// its own line, and no parenthesis spans two of them.
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
        read_value(parameter, source, {0, source->text.size()});
        set_parameter(method, std::move(parameter));
    }
}

}  // namespace

Method method_from_toml(const Source& source) {
    const TomlFile file(source);
    file.check_keys(file.table(), "method file",
                    {"name", "basis", "nodes", "weights", "parameters"});
    const std::string name = file.name();
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
    return method_from_toml(toml_source(path));
}

}  // namespace hvi::gen
