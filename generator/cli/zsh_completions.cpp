// Completions of zsh.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/cli/completions.hpp"
#include "generator/cli/proposals.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/support/shell_word.hpp"

namespace hvi::gen {

namespace {

/// Puts a backslash before characters that separate the parts of a specification.
std::string escaped(std::string_view text, std::string_view separators) {
    std::string result;
    for (const char c : text) {
        if (separators.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

/// Returns the action that proposes the value of an option.
std::string action(const OptionEntry& option) {
    const std::string names = escaped(proposals(option), ":");
    switch (option.value) {
    case Value::file: return "_files";
    case Value::directory: return "_files -/";
    case Value::scene: return "_hvi_gen_scenes";
    case Value::choices:
    case Value::methods: return "_sequence compadd - " + names;
    default: return names.empty() ? " " : "(" + names + ")";
    }
}

/// Returns the options that are not proposed after this one: `(-o --output)`, or nothing.
std::string exclusions(const OptionEntry& option, Command command) {
    std::vector<std::string_view> names;
    for (const OptionEntry* other : not_beside(option, command))
        if (!other->is_word()) names.push_back(other->name);
    if (!option.abbreviation.empty()) names.insert(names.end(), {option.abbreviation, option.name});
    return names.empty() ? "" : fmt::format("({})", fmt::join(names, " "));
}

/// Returns `'(-o --output)'{-o,--output=}'[Write to this file]:FILE:_files'`.
std::string specification(const OptionEntry& option, Command command) {
    const std::string value =
        option.takes_word()
            ? fmt::format(":{}:{}", escaped(option.placeholder, ":"), action(option))
            : "";
    if (option.is_word()) return in_quotes((option.is_repeatable ? "*" : "1") + value);
    const std::string before = exclusions(option, command) + (option.is_repeatable ? "*" : "");
    const std::string name = std::string(option.name) + (value.empty() ? "" : "=");
    const std::string help = fmt::format("[{}]{}", escaped(help_of(option), "[]:"), value);
    if (option.abbreviation.empty()) return in_quotes(before + name + help);
    return fmt::format("{}{{{},{}}}{}", in_quotes(before), option.abbreviation, name,
                       in_quotes(help));
}

std::string arm(const CommandEntry& command) {
    std::string text = fmt::format("{})\n    _arguments", command.name);
    for (const OptionEntry* option : options_of(command.command, State::built))
        text += " \\\n        " + specification(*option, command.command);
    return text + "\n    ;;\n";
}

}  // namespace

std::string zsh_completions() {
    std::string commands, arguments;
    for (const CommandEntry& entry : built_commands()) {
        commands += fmt::format("{}\n", in_quotes(fmt::format("{}:{}", entry.name, entry.help)));
        arguments += arm(entry);
    }
    commands.pop_back();
    arguments.pop_back();
    return fill("completions.zsh.in", {{"commands", commands},
                                       {"arguments", arguments},
                                       {"scenes", proposals(option_of(Command::run, "SCENE"))}});
}

}  // namespace hvi::gen
