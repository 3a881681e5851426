// Runs of scenes that tests write, and what they leave.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"
#include "tests/program/simulate/table.hpp"

namespace hvi::test {

inline const double pi = std::acos(-1.0);

using NumberRows = std::vector<std::vector<double>>;

/// Checks that rows of numbers are others, up to a difference.
inline void check_rows(const NumberRows& found, const NumberRows& expected, double tolerance) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t row = 0; row < found.size(); ++row) {
        REQUIRE(found[row].size() == expected[row].size());
        for (std::size_t k = 0; k < found[row].size(); ++k) {
            CAPTURE(row, k, found[row][k], expected[row][k]);
            CHECK(std::abs(found[row][k] - expected[row][k]) < tolerance);
        }
    }
}

struct SceneRun {
    Outcome outcome;
    std::vector<std::string> events;  ///< lines
    std::vector<std::string> table;   ///< lines
    std::vector<std::vector<double>> tangent;
    std::vector<std::string> sensitivity;  ///< lines
    std::vector<std::string> section;      ///< lines

    /// A row of the table, from 0 on.
    [[nodiscard]] std::vector<double> row(std::size_t k) const {
        return numbers_of(table.at(k + 1));
    }
    [[nodiscard]] std::vector<double> last() const { return numbers_of(table.back()); }

    /// The rows of the table.
    [[nodiscard]] std::vector<std::vector<double>> rows() const {
        std::vector<std::vector<double>> result;
        for (std::size_t k = 0; k + 1 < table.size(); ++k) result.push_back(row(k));
        return result;
    }

    /// The time and the variables of an event, from 0 on.
    [[nodiscard]] std::vector<double> event(std::size_t k) const {
        const std::string& line = events.at(k + 1);
        return numbers_of(line.substr(line.find(',', line.find(',') + 1) + 1));
    }

    /// The numbers behind a name in the summary.
    [[nodiscard]] std::vector<double> said(const std::string& name) const {
        for (const std::string& line : lines_of(outcome.out)) {
            if (line.rfind(name + " ", 0) != 0) continue;
            std::istringstream stream(line.substr(name.size()));
            std::vector<double> numbers;
            for (double number = 0; stream >> number;) numbers.push_back(number);
            return numbers;
        }
        return {};
    }
};

/// Runs a scene in a directory with these words, the first of which is its name.
inline SceneRun run_words_in(const Directory& directory, const std::string& words) {
    use_cache();
    SceneRun result;
    result.outcome =
        shell("exec \"$hvi_gen\" run " + words + " -o out --only table,summary", directory.path());
    const auto lines = [&](const std::string& name) {
        return std::filesystem::exists(directory / "out" / name)
                   ? lines_of(contents(directory / "out" / name))
                   : std::vector<std::string>{};
    };
    result.events = lines("events.csv");
    result.table = lines("trajectory.csv");
    result.sensitivity = lines("sensitivity.csv");
    result.section = lines("section.csv");
    for (const std::string& line : lines("tangent.csv")) result.tangent.push_back(numbers_of(line));
    return result;
}

/// Runs a scene that comes with the program.
inline SceneRun run_words(const std::string& words) { return run_words_in(Directory(), words); }

/// Runs the scene with these words.
inline SceneRun run_scene(const std::string& scene, const std::string& words = "") {
    const Directory directory;
    write(directory / "scene.toml", scene);
    return run_words_in(directory, "scene.toml " + words);
}

}  // namespace hvi::test
