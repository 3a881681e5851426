// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <system_error>

#include "generator/drive/ensemble_row.hpp"
#include "generator/ensembles/number_rows.hpp"
#include "generator/read/toml_file.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr const char* schema = "hvi-study/1";

fs::path file_of(const fs::path& directory) { return directory / "study.toml"; }

void make(const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error) throw EnvironmentError("cannot make " + directory.string() + ": " + error.message());
}

std::string text_of(const Study& study) {
    toml::array columns;
    for (const std::string& name : study.columns) columns.push_back(name);
    std::ostringstream text;
    text
        << "# A study of hvi-gen. Its command goes on with it; `hvi-gen collect` makes one table.\n"
        << toml::table{{"schema", schema},
                       {"hvi", std::string(version)},
                       {"title", study.title},
                       {"command", study.command},
                       {"key", study.key},
                       {"rows", study.rows},
                       {"rows_in_chunk", study.rows_in_chunk},
                       {"columns", std::move(columns)}}
        << "\n";
    return text.str();
}

template <class Value>
Value value_of(const TomlFile& file, const char* name) {
    const auto value = file.table()[name].value<Value>();
    if (!value)
        throw InputError(fmt::format("`{}` is missing in this study", name),
                         file.place(file.table()),
                         "the directory is not one that `hvi-gen ensemble` has made");
    return *value;
}

}  // namespace

fs::path Study::file(std::int64_t chunk, const char* ending) const {
    return directory / "chunks" / fmt::format("{:03}", chunk / in_directory) /
           fmt::format("{:06}.{}", chunk, ending);
}

void begin(const Study& study) {
    make(study.directory);
    const fs::path file = file_of(study.directory);
    if (!fs::exists(file)) return write_file(file, text_of(study));
    const Study there = study_in(study.directory);
    if (there.key == study.key && there.rows_in_chunk == study.rows_in_chunk) return;
    throw EnvironmentError("another study is in " + study.directory.string(),
                           "it is gone on with by: " + there.command +
                               "; or give another directory by -o");
}

Study study_in(const fs::path& directory) {
    const Source text = toml_source(file_of(directory));
    const TomlFile file(text);
    if (value_of<std::string>(file, "schema") != schema)
        throw InputError("this study is of another version of hvi-gen", file.place(file.table()));
    Study study{.directory = directory,
                .title = value_of<std::string>(file, "title"),
                .command = value_of<std::string>(file, "command"),
                .key = value_of<std::string>(file, "key"),
                .rows = value_of<std::int64_t>(file, "rows"),
                .rows_in_chunk = value_of<std::int64_t>(file, "rows_in_chunk"),
                .columns = {}};
    if (const toml::array* columns = file.table()["columns"].as_array())
        for (const toml::node& column : *columns) study.columns.push_back(file.text(column));
    if (study.rows < 1 || study.rows_in_chunk < 1 || study.columns.empty())
        throw InputError("this study has no rows", file.place(file.table()));
    return study;
}

TableHead head_of(const Study& study) {
    TableHead head;
    for (const std::string& name : study.columns) {
        head.columns.push_back({.name = name, .meaning = name});
        if (name == status_column) head.columns.back().words = row_statuses;
    }
    return head;
}

bool is_done(const Study& study, std::int64_t chunk) {
    std::error_code ignored;
    return fs::exists(study.file(chunk, "npy"), ignored);
}

std::vector<bool> done_in(const Study& study, std::int64_t directory) {
    const std::int64_t first = directory * Study::in_directory;
    std::vector<bool> done(Study::in_directory);
    std::error_code error;
    fs::directory_iterator files(study.file(first, "npy").parent_path(), error);
    for (; !error && files != fs::directory_iterator(); files.increment(error)) {
        if (files->path().extension() != ".npy") continue;
        const std::string name = files->path().stem();
        std::int64_t chunk = -1;
        std::from_chars(name.data(), name.data() + name.size(), chunk);
        if (chunk >= first && chunk - first < Study::in_directory)
            done[static_cast<std::size_t>(chunk - first)] = true;
    }
    return done;
}

void write_rows(const Study& study, const fs::path& file,
                const std::vector<std::vector<double>>& rows) {
    make(file.parent_path());
    const fs::path growing = new_file(file.parent_path());
    const auto table = row_file(TableFormat::npy, growing, head_of(study));
    for (const std::vector<double>& row : rows) table->row(row);
    std::error_code error;
    const bool is_whole = table->close();
    if (is_whole) fs::rename(growing, file, error);
    if (is_whole && !error) return;
    fs::remove(growing, error);
    // NOTE: another worker may have finished the study, and tidied it.
    if (!fs::exists(file)) throw EnvironmentError("cannot write " + file.string());
}

void tidy(const Study& study) {
    std::error_code ignored;
    for (const auto& each : fs::recursive_directory_iterator(study.directory / "chunks", ignored))
        if (each.is_regular_file(ignored) && each.path().extension() != ".npy")
            fs::remove(each.path(), ignored);
}

std::vector<std::vector<double>> read_rows(const Study& study, const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return {};
    const auto table = number_rows(std::make_shared<const Source>(Source{"chunk", file.string()}));
    if (table->names() != study.columns)
        throw EnvironmentError(file.string() + " has other columns than its study",
                               "remove it, and run the study again");
    const std::size_t count = study.columns.size();
    const std::vector<double> all = table->rows(0, table->count());
    std::vector<std::vector<double>> result;
    for (auto next = all.begin(); next != all.end(); next += static_cast<std::ptrdiff_t>(count))
        result.emplace_back(next, next + static_cast<std::ptrdiff_t>(count));
    return result;
}

}  // namespace hvi::gen
