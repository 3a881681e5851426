// Finds rows of the table, and words them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/options/option_table.hpp"

namespace hvi::gen {

std::vector<const OptionEntry*> options_of(Command command) {
    std::vector<const OptionEntry*> options;
    for (const OptionEntry& option : option_table())
        if (option.of.contains(command)) options.push_back(&option);
    return options;
}

std::vector<const OptionEntry*> options_of(Command command, State state) {
    std::vector<const OptionEntry*> options = options_of(command);
    std::erase_if(options, [&](const OptionEntry* option) { return option->state != state; });
    return options;
}

const OptionEntry* find_option(Command command, std::string_view name) {
    for (const OptionEntry* option : options_of(command))
        if (option->name == name || (!name.empty() && option->abbreviation == name)) return option;
    return nullptr;
}

const OptionEntry& option_of(Command command, std::string_view name) {
    const OptionEntry* const option = find_option(command, name);
    HVI_CHECK(option != nullptr);
    return *option;
}

const CommandEntry* find_command(std::string_view name) {
    const auto all = command_table();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.name == name; });
    return found == all.end() ? nullptr : &*found;
}

const CommandEntry& entry_of(Command command) {
    const auto all = command_table();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const auto& entry) { return entry.command == command; });
    HVI_CHECK(found != all.end());
    return *found;
}

std::vector<const OptionEntry*> not_beside(const OptionEntry& option, Command command) {
    const auto excludes = [](const OptionEntry& one, const OptionEntry& other) {
        const auto names = split(one.excludes.others, ' ');
        return std::find(names.begin(), names.end(), other.name) != names.end();
    };
    std::vector<const OptionEntry*> others = options_of(command, State::built);
    std::erase_if(others, [&](const OptionEntry* other) {
        return !excludes(option, *other) && !excludes(*other, option);
    });
    return others;
}

std::vector<std::string_view> built(std::span<const Choice> choices) {
    std::vector<std::string_view> names;
    for (const Choice& choice : choices)
        if (choice.state == State::built) names.push_back(choice.name);
    return names;
}

std::string names_of(std::span<const Choice> choices) {
    const std::vector<std::string_view> names = built(choices);
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
        text += names[i];
    }
    return text;
}

std::string help_of(const OptionEntry& option) {
    const std::string help(option.help);
    return option.choices.empty() ? help : help + ": " + names_of(option.choices);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        if (end > 0) pieces.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return pieces;
}

std::string spoken(std::string_view name) {
    return std::string(name == "SCENE" ? "a scene" : name);
}

}  // namespace hvi::gen
