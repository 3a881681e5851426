// The files that a run leaves.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/cli/run_picture.hpp"
#include "generator/cli/run_section.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// Files that a run leaves, all of them whole. Without a directory there are none.
class RunFiles {
public:
    /// Makes the directory. Throws EnvironmentError.
    explicit RunFiles(const std::optional<std::filesystem::path>& directory);

    /// Lets tables grow in named files, so that they remain however the run ends; files that a run
    /// resumes stay. Throws EnvironmentError. Precondition: no table has been asked for.
    void keep_growing(bool goes_on, TableFormat format);
    ~RunFiles();
    RunFiles(const RunFiles&) = delete;
    RunFiles& operator=(const RunFiles&) = delete;

    /// Whether there are any files.
    [[nodiscard]] bool any() const { return directory_ != nullptr; }
    /// Returns the file of the growing table.
    [[nodiscard]] std::filesystem::path table() const;
    /// Returns the file of the growing table of events.
    [[nodiscard]] std::filesystem::path events();
    /// Returns the file of the picture's growing table. Precondition: there is a directory.
    [[nodiscard]] std::filesystem::path table_of_picture();

    /// Keeps the derivative of the flow, row by row, where there is one. Throws EnvironmentError.
    void keep_tangent(const std::vector<double>& entries) const;
    /// Keeps `sensitivity.csv`, unless the table is empty.
    void keep_sensitivities(const std::string& table) const;
    /// Keeps `section.csv`, unless the table is empty.
    void keep_section_map(const std::string& table) const;

    /// Keeps the frequencies of columns, where there are some. Throws EnvironmentError.
    void keep_frequencies(const std::vector<ColumnFrequencies>& found) const;

    /// Keeps the picture of events, where there is one. Throws EnvironmentError. Precondition:
    /// their table has been kept.
    void keep_section(SectionPicture picture) const;

    /// Keeps the tables as far as they have been written. Throws EnvironmentError.
    void keep_table(const Simulation& run, TableFormat format);

    /// Keeps the wished files. Throws EnvironmentError.
    void keep(const RunSubject& subject, const Steps& asked, const Simulation& run,
              RunTables tables, const std::set<RunFile>& wished, const std::string& summary);

private:
    class Unfinished;
    class ResultDirectory;

    std::unique_ptr<ResultDirectory> directory_;
    std::unique_ptr<Unfinished> table_, events_, table_of_picture_;  // in directory_
    bool stays_ = false;
};

}  // namespace hvi::gen
