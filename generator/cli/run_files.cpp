// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <system_error>
#include <utility>

#include "generator/cli/run_frequencies.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/draw/trajectory.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

const char* table_name(TableFormat format) {
    switch (format) {
    case TableFormat::csv: return "trajectory.csv";
    case TableFormat::npy: return "trajectory.npy";
    case TableFormat::hdf5: return "trajectory.h5";
    }
    HVI_CHECK(false);
    return "";
}
constexpr const char* tangent_name = "tangent.csv";
constexpr const char* sensitivity_name = "sensitivity.csv";
constexpr const char* section_map_name = "section.csv";
constexpr const char* frequencies_name = "frequencies.csv";
constexpr const char* events_name = "events.csv";
constexpr const char* picture_name = "picture.svg";
constexpr const char* section_name = "events.svg";
constexpr const char* summary_name = "summary.txt";

}  // namespace

/// A file that one of our programs fills. Its destructor removes it unless it is renamed or stays.
class RunFiles::Unfinished {
public:
    explicit Unfinished(const fs::path& directory) : path_(new_file(directory)) {}
    /// Names a file that is kept if it `stays`.
    Unfinished(fs::path path, bool stays) : path_(std::move(path)), stays_(stays) {}
    ~Unfinished() {
        std::error_code ignored;
        if (!stays_) fs::remove(path_, ignored);
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

    void rename_to(const fs::path& target) {
        std::error_code error;
        fs::rename(path_, target, error);
        if (error)
            throw EnvironmentError("cannot write " + target.string() + ": " + error.message());
    }

private:
    fs::path path_;
    bool stays_ = false;
};

/// A directory for results. Its destructor removes it where it created it and nothing is in it.
class RunFiles::ResultDirectory {
public:
    explicit ResultDirectory(fs::path path) : path_(std::move(path)) {
        std::error_code ignored;
        for (fs::path each = path_; !each.empty() && !fs::exists(each, ignored);
             each = each.parent_path())
            missing_.push_back(each);
        make_directory(path_);
    }
    ~ResultDirectory() {
        std::error_code ignored;
        for (const fs::path& each : missing_)
            if (fs::is_empty(each, ignored)) fs::remove(each, ignored);
    }
    ResultDirectory(const ResultDirectory&) = delete;
    ResultDirectory& operator=(const ResultDirectory&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
    std::vector<fs::path> missing_;  ///< directories that were missing, the innermost first
};

RunFiles::RunFiles(const std::optional<fs::path>& directory) {
    if (!directory) return;
    directory_ = std::make_unique<ResultDirectory>(*directory);
    table_ = std::make_unique<Unfinished>(*directory);
}

RunFiles::~RunFiles() = default;

namespace {

fs::path growing(const fs::path& directory, const char* name) {
    return directory / (std::string(name) + ".partial");
}

/// Moves a finished table, or one that seemed finished, back to the name of a growing one.
void let_grow(const fs::path& directory, const char* name) {
    std::error_code ignored;
    const fs::path partial = growing(directory, name);
    if (!fs::exists(partial, ignored)) fs::rename(directory / name, partial, ignored);
}

}  // namespace

void RunFiles::keep_growing(bool goes_on, TableFormat format) {
    if (!directory_) return;
    stays_ = true;
    const fs::path& directory = directory_->path();
    if (goes_on)
        for (const char* name : {table_name(format), events_name}) let_grow(directory, name);
    table_ = std::make_unique<Unfinished>(growing(directory, table_name(format)), true);
    if (goes_on && !fs::exists(table_->path()))
        throw EnvironmentError("the table that the checkpoint goes on with is not there: " +
                                   table_->path().string(),
                               "give the directory of the run by -o");
}

fs::path RunFiles::table() const { return table_ ? table_->path() : "/dev/null"; }

fs::path RunFiles::events() {
    if (!directory_) return "/dev/null";
    events_ = stays_ ? std::make_unique<Unfinished>(growing(directory_->path(), events_name), true)
                     : std::make_unique<Unfinished>(directory_->path());
    return events_->path();
}

fs::path RunFiles::table_of_picture() {
    table_of_picture_ = std::make_unique<Unfinished>(directory_->path());
    return table_of_picture_->path();
}

void RunFiles::keep_tangent(const std::vector<double>& entries) const {
    if (!directory_ || entries.empty()) return;
    const auto columns = static_cast<std::size_t>(std::lround(std::sqrt(entries.size())));
    std::string text;
    for (std::size_t k = 0; k < entries.size(); ++k)
        text += fmt::format("{}{}", entries[k], (k + 1) % columns == 0 ? '\n' : ',');
    write_file(directory_->path() / tangent_name, text);
}

void RunFiles::keep_sensitivities(const std::string& table) const {
    if (!directory_ || table.empty()) return;
    write_file(directory_->path() / sensitivity_name, table);
}

void RunFiles::keep_section_map(const std::string& table) const {
    if (!directory_ || table.empty()) return;
    write_file(directory_->path() / section_map_name, table);
}

void RunFiles::keep_frequencies(const std::vector<ColumnFrequencies>& found) const {
    if (directory_ && !found.empty())
        write_file(directory_->path() / frequencies_name, table_of(found));
}

void RunFiles::keep_section(SectionPicture picture) const {
    if (!directory_ || picture.events.empty()) return;
    picture.table = directory_->path() / events_name;
    write_file(directory_->path() / section_name, draw(picture));
}

void RunFiles::keep_table(const Simulation& run, TableFormat format) {
    if (!directory_) return;
    if (!run.ok() && !mark_incomplete(format, table_->path(), run.status))
        throw EnvironmentError("cannot write " + table_->path().string());
    table_->rename_to(directory_->path() / table_name(format));
    if (events_) events_->rename_to(directory_->path() / events_name);
}

void RunFiles::keep(const RunSubject& subject, const Steps& asked, const Simulation& run,
                    RunTables tables, const std::set<RunFile>& wished, const std::string& summary) {
    if (!directory_) return;
    if (wished.contains(RunFile::table)) {
        keep_table(run, tables.own.format);
        tables.own.file = directory_->path() / table_name(tables.own.format);
    }
    if (wished.contains(RunFile::summary)) write_file(directory_->path() / summary_name, summary);
    if (tables.plain) tables.own = *tables.plain;
    if (wished.contains(RunFile::picture))
        write_file(directory_->path() / picture_name, draw(picture(subject, asked, run, tables)));
}

}  // namespace hvi::gen
