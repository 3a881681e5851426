// The options of a command with the words that CLI11 gave to them, and their places.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "generator/cli/command_line.hpp"
#include "generator/options/option_table.hpp"

namespace hvi::gen {

/// Returns the items between the commas of a list, without blanks around them; each source has the
/// list's name. Throws InputError where an item is missing.
[[nodiscard]] std::vector<Given> list_items(const Given& list);

/// Throws InputError for something that is to come.
[[noreturn]] void refuse_to_come(std::string_view name, const Place& place);

/// A command with the words that CLI11 gave to its options. A function that reads a value throws
/// InputError for words that do not fit the option's row in the table. Precondition of all
/// functions that take an option: it is one of the command.
class Words {
public:
    Words(Command command, const CLI::App& parsed, const CommandLine& line)
        : command_(command), parsed_(parsed), line_(line) {}

    [[nodiscard]] Command command() const { return command_; }

    /// Returns the words that belong to no option.
    [[nodiscard]] std::vector<std::string> rest() const { return parsed_.remaining(); }

    /// Returns the place of the n-th occurrence of an option, by whichever of its names.
    [[nodiscard]] Place place(std::string_view option, std::size_t n = 0) const;

    [[nodiscard]] bool has(std::string_view option) const {
        return parsed_.count(std::string(option)) > 0;
    }

    /// Returns the values of an option, one for each occurrence.
    [[nodiscard]] const std::vector<std::string>& values(std::string_view option) const {
        return parsed_.get_option(std::string(option))->results();
    }

    /// Returns the values as texts of the option.
    [[nodiscard]] std::vector<Given> texts(std::string_view option) const;

    /// Returns the value of an option that can be given once, or null.
    [[nodiscard]] Given value(std::string_view option) const;

    /// Returns the value of an option that takes a file or a directory; it is not empty.
    [[nodiscard]] Given file(std::string_view option) const;

    [[nodiscard]] std::optional<int> whole_number(std::string_view option) const;

    [[nodiscard]] std::optional<double> fraction(std::string_view option) const;

    template <class Enumeration>
    [[nodiscard]] std::optional<Enumeration> choice(std::string_view option) const {
        const Choice* chosen = chosen_of(option, value(option));
        return chosen ? std::optional(static_cast<Enumeration>(chosen->value)) : std::nullopt;
    }

    /// Returns the choice of a mode: the first one where no value stands behind `=`; nothing where
    /// the option is not given.
    template <class Enumeration>
    [[nodiscard]] std::optional<Enumeration> mode(std::string_view option) const {
        if (!has(option)) return {};
        const std::string& text = values(option).back();
        const std::span<const Choice> choices = option_of(command_, option).choices;
        for (const Choice& choice : choices)
            if (choice.name == text) return static_cast<Enumeration>(choice.value);
        return static_cast<Enumeration>(choices.front().value);
    }

    /// Returns the items of a list between commas; none when the option is not given.
    template <class Enumeration>
    [[nodiscard]] std::set<Enumeration> choices(std::string_view option) const {
        std::set<Enumeration> all;
        if (const Given list = value(option))
            for (const Given& item : list_items(list))
                all.insert(static_cast<Enumeration>(chosen_of(option, item)->value));
        return all;
    }

private:
    /// Returns null where there is no text.
    [[nodiscard]] const Choice* chosen_of(std::string_view option, const Given& text) const;

    Command command_;
    const CLI::App& parsed_;
    const CommandLine& line_;
};

}  // namespace hvi::gen
