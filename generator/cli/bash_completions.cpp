// Completions of bash.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/cli/completions.hpp"
#include "generator/cli/proposals.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/support/shell_word.hpp"

namespace hvi::gen {

namespace {

/// Returns the facts about a value that the template's functions know.
std::string facts(const OptionEntry& option) {
    std::string text;
    const std::string names = proposals(option);
    if (!names.empty()) text += fmt::format(" candidates={}", in_quotes(names));
    if (option.value == Value::choices || option.value == Value::methods) text += " listed=yes";
    if (option.value == Value::file || option.value == Value::scene) text += " files=file";
    if (option.value == Value::directory) text += " files=directory";
    return text;
}

/// Returns `'tableau --method' | 'check --method') candidates='midpoint ...' ;;`.
std::string arm(const OptionEntry& option) {
    std::string pattern;
    for (const CommandEntry& entry : built_commands()) {
        if (!option.of.contains(entry.command)) continue;
        for (const std::string_view name : {option.abbreviation, option.name})
            if (!name.empty())
                pattern += fmt::format("{}'{} {}'", pattern.empty() ? "" : " | ", entry.name, name);
    }
    return fmt::format("{}){} ;;", pattern, facts(option));
}

}  // namespace

std::string bash_completions() {
    std::vector<std::string> values, words, options;
    std::vector<std::string_view> commands;
    for (const OptionEntry& option : option_table()) {
        if (option.state == State::to_come) continue;
        if (option.is_word())
            words.push_back(
                fmt::format("{}){} ;;", command_names(option.of, " | "), facts(option)));
        else if (option.takes_word())
            values.push_back(arm(option));
    }
    for (const CommandEntry& entry : built_commands()) {
        commands.push_back(entry.name);
        options.push_back(
            fmt::format("{}) candidates='{}' ;;", entry.name, option_names(entry.command)));
    }
    const auto lines = [](const auto& all) { return fmt::format("{}", fmt::join(all, "\n")); };
    return fill("completions.bash.in", {{"commands", fmt::format("{}", fmt::join(commands, " "))},
                                        {"options", lines(options)},
                                        {"values", lines(values)},
                                        {"words", lines(words)}});
}

}  // namespace hvi::gen
