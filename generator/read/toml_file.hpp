// TOML files, with the place of every word. toml++ reads the TOML. Numbers are taken from the text
// as they are written, since 0.1 as a double is not 1/10.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// Reads the text of a file of at most 1 MiB. Throws InputError as read_file does.
[[nodiscard]] Source toml_source(const std::filesystem::path& path);

using TomlEntry = std::pair<const toml::key*, const toml::node*>;

/// Returns the entries of a table in the order of the file. NOTE: toml++ sorts by key.
[[nodiscard]] std::vector<TomlEntry> in_order(const toml::table& table);

/// A TOML text that knows the place of each of its words.
class TomlFile {
public:
    /// Throws InputError for text that is no TOML. `file` must outlive the TomlFile.
    explicit TomlFile(const Source& file);

    [[nodiscard]] const toml::table& table() const { return table_; }
    [[nodiscard]] Place place(const toml::source_region& region) const;
    [[nodiscard]] Place place(const toml::node& node) const { return place(node.source()); }

    /// Returns a text that stands in the file, under the name `FILE:LINE`, where LINE is its first
    /// line. The text keeps its line breaks when it is whole lines of the file, unchanged.
    [[nodiscard]] std::shared_ptr<const Source> source(const toml::node& node,
                                                       std::string text) const;

    /// Returns a string, or a number as it is written. Throws InputError for anything else.
    [[nodiscard]] std::string text(const toml::node& node) const;

    /// Throws InputError, with a suggestion, for a key of the table that is not in `known`. `what`
    /// is the table's name in messages: `method file`.
    void check_keys(const toml::table& table, std::string_view what,
                    const std::vector<std::string_view>& known) const;

    /// Returns the key `name`, or an empty text. Throws InputError for special characters: the name
    /// goes into comments, class names and titles.
    [[nodiscard]] std::string name() const;

private:
    [[nodiscard]] std::size_t begin_of_line(toml::source_index number) const;
    [[nodiscard]] std::string line(toml::source_index number) const;
    [[nodiscard]] std::string written_number(const toml::node& node) const;

    const Source& file_;
    toml::table table_;
};

}  // namespace hvi::gen
