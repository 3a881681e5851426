// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/proposals.hpp"

#include <fmt/format.h>

#include "generator/read/catalogue.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

namespace {

using Names = std::vector<std::string>;

Names names_of_families(std::span<const FamilyEntry> families) {
    Names names;
    for (const FamilyEntry& family : families) names.push_back(fmt::format("{}:", family.name));
    return names;
}

Names names_of_methods() {
    Names names;
    for (const MethodEntry& method : named_methods()) names.emplace_back(method.name);
    for (const SplittingEntry& entry : splittings())
        names.emplace_back(entry.name.substr(0, entry.name.find('S')));
    for (std::string& family : names_of_families(node_families()))
        names.push_back(std::move(family));
    return names;
}

Names values(const OptionEntry& option) {
    Names names;
    switch (option.value) {
    case Value::choice:
    case Value::choices:
        for (const std::string_view name : built(option.choices)) names.emplace_back(name);
        return names;
    case Value::method:
    case Value::methods: return names_of_methods();
    case Value::basis: return names_of_families(basis_families());
    case Value::nodes: return names_of_families(node_families());
    case Value::composition:
        for (const std::string_view name : composition_names()) names.emplace_back(name);
        return names;
    case Value::scene:
        for (const SceneEntry& scene : scenes()) names.emplace_back(scene.name);
        return names;
    case Value::none:
    case Value::mode:
    case Value::text:
    case Value::whole:
    case Value::fraction:
    case Value::file:
    case Value::directory: break;
    }
    return names;
}

}  // namespace

std::string proposals(const OptionEntry& option) {
    return fmt::format("{}", fmt::join(values(option), " "));
}

std::string option_names(Command command) {
    std::vector<std::string_view> names;
    for (const OptionEntry* option : options_of(command, State::built))
        if (!option->is_word()) names.push_back(option->name);
    return fmt::format("{}", fmt::join(names, " "));
}

std::vector<CommandEntry> built_commands() {
    std::vector<CommandEntry> built;
    for (const CommandEntry& entry : command_table())
        if (entry.state == State::built) built.push_back(entry);
    return built;
}

std::string command_names(Commands commands, std::string_view separator) {
    std::vector<std::string_view> names;
    for (const CommandEntry& entry : built_commands())
        if (commands.contains(entry.command)) names.push_back(entry.name);
    return fmt::format("{}", fmt::join(names, separator));
}

}  // namespace hvi::gen
