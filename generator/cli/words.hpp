// What CLI11 gave to the options of a command, with the places of words in the command line.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "generator/cli/command_line.hpp"

namespace hvi::gen {

/// The items between the commas of a list, without blanks around them; the name of each source is
/// that of the list. Throws InputError where one is missing.
[[nodiscard]] std::vector<Given> list_items(const Given& list);

using OptionGroups = std::vector<std::vector<std::string>>;

/// A command with the words that CLI11 gave to its options. All but place() and values() throw
/// InputError for words that are not what they ask for.
class Words {
public:
    Words(const CLI::App& command, const CommandLine& line) : command_(command), line_(line) {}

    /// CLI11 takes the next word for a value, even when it is another option.
    void check_values() const;

    /// The place of the n-th occurrence of an option, by whichever of its names.
    [[nodiscard]] Place place(const std::string& option, std::size_t n = 0) const;

    /// The values of an option, one for each occurrence.
    [[nodiscard]] const std::vector<std::string>& values(const std::string& option) const {
        return command_.get_option(option)->results();
    }

    /// The same as texts of the option.
    [[nodiscard]] std::vector<Given> texts(const std::string& option) const;

    /// The value of an option that can be given once, or null.
    [[nodiscard]] Given value(const std::string& option) const;

    [[nodiscard]] bool flag(const std::string& option) const;

    /// Checks that the options that are given are all of one group.
    void one_form_of(const OptionGroups& groups) const;

    [[nodiscard]] std::optional<int> number(const std::string& option, int least, int most) const;

    /// A positive number below 1.
    [[nodiscard]] std::optional<double> fraction(const std::string& option) const;

    /// The value of an option with a few possible ones; the first when it is not given.
    [[nodiscard]] std::size_t choice(const std::string& option,
                                     const std::vector<std::string_view>& choices) const;

    /// The items of a list between commas, which are among the choices; none when it is not given.
    [[nodiscard]] std::set<std::string> chosen(const std::string& option,
                                               const std::vector<std::string_view>& choices) const;

private:
    const CLI::App& command_;
    const CommandLine& line_;
};

}  // namespace hvi::gen
