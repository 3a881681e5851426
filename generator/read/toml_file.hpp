// TOML files, with the place of every word. toml++ reads the TOML; numbers are taken from the text
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

/// The text of a file of at most 1 MiB. Throws InputError as read_file does.
[[nodiscard]] Source toml_source(const std::filesystem::path& path);

using TomlEntry = std::pair<const toml::key*, const toml::node*>;

/// Entries of a table, as they stand in the file. NOTE: toml++ sorts by key.
[[nodiscard]] std::vector<TomlEntry> in_order(const toml::table& table);

/// A TOML text that can say where in it something stands.
class TomlFile {
public:
    /// Throws InputError for what is no TOML. `file` must outlive it.
    explicit TomlFile(const Source& file);

    [[nodiscard]] const toml::table& table() const { return table_; }
    [[nodiscard]] Place place(const toml::source_region& region) const;
    [[nodiscard]] Place place(const toml::node& node) const { return place(node.source()); }

    /// A text that stands in the file, under the name `FILE:LINE`, where LINE is its first one. It
    /// keeps its line breaks when it is lines of the file as they stand there.
    [[nodiscard]] std::shared_ptr<const Source> source(const toml::node& node,
                                                       std::string text) const;

    /// A string, or a number as it is written. Throws InputError for anything else.
    [[nodiscard]] std::string text(const toml::node& node) const;

    /// Throws InputError, with what may have been meant, for a key of the table that is not known
    /// in such a one; `what` is `method file`.
    void check_keys(const toml::table& table, std::string_view what,
                    const std::vector<std::string_view>& known) const;

    /// The key `name`, or an empty text. It goes into comments, class names and titles, so it stays
    /// plain: throws InputError for other characters.
    [[nodiscard]] std::string name() const;

private:
    [[nodiscard]] std::size_t begin_of_line(toml::source_index number) const;
    [[nodiscard]] std::string line(toml::source_index number) const;
    [[nodiscard]] std::string written_number(const toml::node& node) const;

    const Source& file_;
    toml::table table_;
};

}  // namespace hvi::gen
