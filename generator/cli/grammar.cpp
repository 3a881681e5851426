// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/grammar.hpp"

#include <string>

#include "generator/options/option_table.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {

namespace {

std::string names(const OptionEntry& option) {
    const std::string abbreviation(option.abbreviation);
    return (abbreviation.empty() ? "" : abbreviation + ",") + std::string(option.name);
}

/// Breaks the help of an option into lines. NOTE: CLI11 puts lines below each other, but breaks
/// none itself.
std::string lines_of_help(const OptionEntry& option) {
    constexpr std::size_t longest = 68;
    std::string text = help_of(option);
    for (std::size_t begin = 0; text.size() - begin > longest;) {
        const std::size_t blank = text.rfind(' ', begin + longest);
        if (blank == std::string::npos || blank <= begin) break;
        text[blank] = '\n';
        begin = blank + 1;
    }
    return text;
}

void add_value(CLI::App& command, const OptionEntry& option) {
    // NOTE: exactly one value for each occurrence, so that no word behind it is swallowed. Only
    // words that stand alone are one occurrence, of as many as there are.
    command
        .add_option(
            names(option), [](const CLI::results_t&) { return true; }, lines_of_help(option))
        ->expected(1)
        ->allow_extra_args(option.is_word() && option.is_repeatable)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name(std::string(option.placeholder));
}

/// Adds an option that is to come. It is known, so that it can be refused by its name, but not
/// shown.
void add_to_come(CLI::App& command, const OptionEntry& option) {
    CLI::Option& added = *command.add_option(
        names(option), [](const CLI::results_t&) { return true; }, "");
    if (option.value == Value::none) {
        added.expected(0);
    } else {
        added.expected(0, 1);
    }
    added.multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->group("");
}

void add(CLI::App& command, const OptionEntry& option) {
    if (option.name == "--help")
        command.set_help_flag(names(option), lines_of_help(option));
    else if (!option.takes_word())
        command.add_flag(names(option))->description(lines_of_help(option));
    else
        add_value(command, option);
}

void add(CLI::App& app, const CommandEntry& entry) {
    CLI::App& command = *app.add_subcommand(std::string(entry.name), std::string(entry.help));
    command.allow_extras();
    command.set_help_flag();
    if (entry.state == State::to_come) {
        command.group("");
        return;
    }
    // NOTE: options that are not shown come first, else CLI11 leaves a line for them at the end.
    for (const OptionEntry* option : options_of(entry.command, State::to_come))
        add_to_come(command, *option);
    for (const OptionEntry* option : options_of(entry.command, State::built)) {
        add(command, *option);
        if (option->value == Value::method) command.footer(std::string(method_help()));
    }
}

}  // namespace

void describe(CLI::App& app) {
    app.name("hvi-gen");
    app.description("Derives symplectic integrators exactly and writes them as C++ headers.");
    app.set_version_flag("--version", "hvi-gen " + std::string(version));
    app.require_subcommand(0, 1);
    app.allow_extras();
    for (const CommandEntry& entry : command_table()) add(app, entry);
}

}  // namespace hvi::gen
