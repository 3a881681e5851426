// The key small_steps of the section [split] of a scene file.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "generator/read/nearest.hpp"
#include "generator/read/scene_reader.hpp"

namespace hvi::gen {

namespace {

constexpr std::int64_t most_small_steps = 1'000'000;

std::vector<std::string_view> names_of(const std::vector<NamedIndexed>& parts) {
    std::vector<std::string_view> names;
    for (const NamedIndexed& part : parts) names.push_back(part.name);
    return names;
}

}  // namespace

/// Reads the names of fast parts, two or more of the parts but not all.
std::set<std::string> SceneReader::fast_parts(const toml::node& node,
                                              const IndexedSplit& split) const {
    const std::vector<std::string_view> names = names_of(split.parts);
    const auto* array = node.as_array();
    if (array == nullptr)
        throw InputError("a list of fast parts is wanted here", file_.place(node),
                         fmt::format("write [\"{}\"]", fmt::join(names, "\", \"")));
    std::set<std::string> fast;
    for (const toml::node& text : *array) {
        const std::string name = file_.text(text);
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw InputError(fmt::format("`{}` is no part", name), file_.place(text),
                             did_you_mean(name, names, "the parts are " + listed(names)));
        if (!fast.insert(name).second)
            throw InputError(fmt::format("`{}` is named twice", name), file_.place(text));
    }
    if (fast.size() < 2)
        throw InputError("small steps are taken by two parts or more", file_.place(node),
                         "the flow of one part is exact, in steps of any size");
    if (fast.size() == names.size())
        throw InputError("all parts are fast", file_.place(node),
                         "leave a slow one out; where all are fast, take smaller steps");
    return fast;
}

/// Reads `small_steps = {parts = ["bond", "T"], count = 10}`.
void SceneReader::read_small_steps(const toml::node& node, IndexedSplit& split) const {
    const auto* table = node.as_table();
    if (table != nullptr) file_.check_keys(*table, "choice of small steps", {"parts", "count"});
    const toml::node* parts = table == nullptr ? nullptr : table->get("parts");
    const toml::node* count = table == nullptr ? nullptr : table->get("count");
    if (parts == nullptr || count == nullptr)
        throw InputError("small steps are of parts, and so many in a large one", file_.place(node),
                         "write small_steps = {parts = [\"A\", \"B\"], count = 10}");
    const std::set<std::string> fast = fast_parts(*parts, split);
    const std::int64_t steps = count->value_exact<std::int64_t>().value_or(0);
    if (steps < 1 || steps > most_small_steps)
        throw InputError(
            fmt::format("a whole number from 1 to {} is wanted here", most_small_steps),
            file_.place(*count));
    std::stable_partition(split.parts.begin(), split.parts.end(),
                          [&](const NamedIndexed& part) { return fast.count(part.name) == 1; });
    split.small_steps = {fast.size(), static_cast<std::size_t>(steps)};
}

}  // namespace hvi::gen
