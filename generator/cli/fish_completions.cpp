// Completions of fish.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/cli/completions.hpp"
#include "generator/cli/proposals.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {

namespace {

/// Quotes a text for fish, where a backslash escapes.
std::string in_quotes_of_fish(std::string_view text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result + "'";
}

/// Describes the argument of an option: files, names, or any text.
std::string arguments(const OptionEntry& option) {
    const std::string names = proposals(option);
    switch (option.value) {
    case Value::none:
    case Value::mode: return "";
    case Value::file: return " -r -F";
    case Value::directory: return " -x -a '(__fish_complete_directories)'";
    case Value::scene: return " -F -a " + in_quotes_of_fish(names);
    case Value::choices:
    case Value::methods: return " -x -a " + in_quotes_of_fish("(__fish_append , " + names + ")");
    default:
        return (option.is_word() ? "" : " -x") +
               (names.empty() ? "" : " -a " + in_quotes_of_fish(names));
    }
}

std::string line(const OptionEntry& option) {
    std::string text = fmt::format("complete -c hvi-gen -n '__fish_seen_subcommand_from {}'",
                                   command_names(option.of, " "));
    if (!option.abbreviation.empty()) text += fmt::format(" -s {}", option.abbreviation.substr(1));
    if (!option.is_word()) text += fmt::format(" -l {}", option.name.substr(2));
    return text + fmt::format("{} -d {}", arguments(option), in_quotes_of_fish(help_of(option)));
}

}  // namespace

std::string fish_completions() {
    std::string commands, options;
    for (const CommandEntry& entry : built_commands())
        commands += fmt::format("complete -c hvi-gen -n __fish_use_subcommand -a {} -d {}\n",
                                entry.name, in_quotes_of_fish(entry.help));
    for (const OptionEntry& option : option_table())
        if (option.state == State::built) options += line(option) + "\n";
    commands.pop_back();
    options.pop_back();
    return fill("completions.fish.in", {{"commands", commands}, {"options", options}});
}

}  // namespace hvi::gen
