// Studies of scenes that tests write, and their rows.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

namespace hvi::test {

/// A table with names, as texts.
struct TextTable {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;

    [[nodiscard]] const std::string& at(std::size_t row, const std::string& name) const {
        const auto found = std::find(names.begin(), names.end(), name);
        INFO("column " << name);
        REQUIRE(found != names.end());
        return rows.at(row).at(static_cast<std::size_t>(found - names.begin()));
    }
    [[nodiscard]] double number(std::size_t row, const std::string& name) const {
        return std::stod(at(row, name));
    }
};

/// Returns the cells of a line. NOTE: names with commas stand in quotes.
inline std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (const char c : line) {
        if (c == '"') {
            is_quoted = !is_quoted;
        } else if (c == ',' && !is_quoted) {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

inline TextTable table_of(const std::string& text) {
    TextTable table;
    for (const std::string& line : lines_of(text)) {
        if (table.names.empty())
            table.names = cells_of(line);
        else
            table.rows.push_back(cells_of(line));
    }
    return table;
}

/// Runs a line of shell, in which $study is `hvi-gen ensemble scene.toml -o study`, in a directory.
inline Outcome study_in(const Directory& directory, const std::string& line) {
    use_cache();
    return shell("study=\"$hvi_gen ensemble scene.toml -o study\"; " + line, directory.path());
}

/// The rows of a study of a scene that was asked for with these words.
inline TextTable study_of(const std::string& scene, const std::string& words) {
    const Directory directory;
    write(directory / "scene.toml", scene);
    const Outcome outcome = study_in(directory, "eval \"$study " + words +
                                                    "\" && \"$hvi_gen\" collect study -o rows.csv");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return table_of(contents(directory / "rows.csv"));
}

/// The last row of a run of a scene, with the summary.
struct LastRow {
    TextTable table;
    std::string summary;

    [[nodiscard]] const std::string& at(const std::string& name) const {
        return table.at(table.rows.size() - 1, name);
    }
};

inline LastRow run_of(const std::string& scene, const std::string& words) {
    use_cache();
    const Directory directory;
    write(directory / "scene.toml", scene);
    const Outcome outcome =
        shell("eval \"$hvi_gen run scene.toml -o out --only table,summary " + words + "\"",
              directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return {table_of(contents(directory / "out" / "trajectory.csv")), outcome.out};
}

}  // namespace hvi::test
