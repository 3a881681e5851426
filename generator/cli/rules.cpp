// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

void check_built(const Words& words) {
    for (const OptionEntry* option : options_of(words.command(), State::to_come))
        if (words.has(option->name)) refuse_to_come(option->name, words.place(option->name));
}

/// Refuses words that CLI11 could not assign.
void check_rest(const Words& words, const CommandLine& line) {
    const std::vector<std::string> rest = words.rest();
    if (rest.empty()) return;
    const std::string& word = rest.front();
    const bool takes_method = find_option(words.command(), "--method") != nullptr;
    const std::string help =
        fmt::format("`hvi-gen {} --help` lists the options", entry_of(words.command()).name);
    if (!word.starts_with("-"))
        throw InputError("unexpected word `" + word + "`", line.place({word}),
                         takes_method ? "a method is given by --method, as in --method gauss:2"
                                      : help);
    std::vector<std::string_view> names;
    for (const OptionEntry* option : options_of(words.command(), State::built))
        if (!option->is_word()) names.push_back(option->name);
    throw InputError("unknown option `" + word + "`", line.place({word}),
                     did_you_mean(word, names, help));
}

/// Refuses a value that is another option, which CLI11 takes as a value.
void check_value(const Words& words, const OptionEntry& option) {
    const std::vector<std::string>& values = words.values(option.name);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string_view word = std::string_view(values[i]).substr(0, values[i].find('='));
        if (word.starts_with('-') && find_option(words.command(), word) != nullptr)
            throw InputError(fmt::format("{} needs a value", option.name),
                             words.place(option.name, i));
    }
    if (values.size() > 1 && !option.is_repeatable)
        throw InputError(fmt::format("{} is given twice", option.name),
                         words.place(option.name, 1));
}

void check_mode(const Words& words, const OptionEntry& option, const std::string& value) {
    const auto is_it = [&](const Choice& choice) { return choice.name == value; };
    if (value == "true" || std::any_of(option.choices.begin(), option.choices.end(), is_it)) return;
    throw InputError(fmt::format("no such value of {}: `{}`", option.name, value),
                     words.place(option.name),
                     did_you_mean(value, built(option.choices),
                                  "one of " + names_of(option.choices) + ", behind ="));
}

void check_flag(const Words& words, const OptionEntry& option) {
    for (const std::string& value : words.values(option.name))
        if (option.value == Value::mode)
            check_mode(words, option, value);
        else if (value != "true")
            throw InputError(fmt::format("{} takes no value", option.name),
                             words.place(option.name));
}

/// Returns the error for a broken relation between options. `usual` is the wording unless the table
/// has its own; `other` is the other option as messages name it.
std::string said(const Relation& relation, std::string_view usual, const OptionEntry& option,
                 const std::string& other) {
    return relation.what.empty() ? fmt::format("{} {} {}", spoken(option.name), usual, other)
                                 : fmt::format(fmt::runtime(relation.what), other);
}

void check_excluded(const Words& words, const OptionEntry& option) {
    const Relation& excludes = option.excludes;
    for (const std::string_view other : split(excludes.others, ' ')) {
        if (find_option(words.command(), other) == nullptr || !words.has(other)) continue;
        throw InputError(
            said(excludes, "does not go with", option, spoken(other)), words.place(other),
            std::string(excludes.help.empty() ? "leave one of them out" : excludes.help));
    }
}

void check_needed(const Words& words, const OptionEntry& option) {
    for (const std::string_view needed : split(option.needs.others, ' ')) {
        std::string names;
        bool is_there = false;
        for (const std::string_view other : split(needed, '|')) {
            names += (names.empty() ? "" : " or ") + spoken(other);
            is_there = is_there || words.has(other);
        }
        if (!is_there)
            throw InputError(said(option.needs, "needs", option, names), words.place(option.name),
                             std::string(option.needs.help));
    }
}

}  // namespace

void check_rules(const Words& words, const CommandLine& line) {
    check_built(words);
    const auto options = options_of(words.command(), State::built);
    for (const OptionEntry* option : options)
        if (option->takes_word()) check_value(words, *option);
    check_rest(words, line);
    for (const OptionEntry* option : options)
        if (!option->takes_word()) check_flag(words, *option);
    for (const OptionEntry* option : options)
        if (words.has(option->name)) check_excluded(words, *option);
    for (const OptionEntry* option : options)
        if (words.has(option->name)) check_needed(words, *option);
}

void check_command(const CommandEntry& command, const CommandLine& line) {
    if (command.state == State::to_come)
        refuse_to_come(command.name, line.place({std::string(command.name)}));
}

}  // namespace hvi::gen
