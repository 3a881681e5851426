// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/ensemble_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "generator/cli/run_wishes.hpp"
#include "generator/cli/words.hpp"
#include "generator/draw/map.hpp"
#include "generator/drive/ensemble_row.hpp"
#include "generator/ensembles/study_rows.hpp"
#include "generator/read/nearest.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/shell_word.hpp"

namespace hvi::gen {

namespace {

std::size_t place_of(const Study& study, std::string_view name) {
    const auto found = std::find(study.columns.begin(), study.columns.end(), name);
    return static_cast<std::size_t>(found - study.columns.begin());
}

/// Returns the places of the columns that a map names.
std::vector<std::size_t> columns_of(const Study& study, const Given& map) {
    std::vector<std::size_t> places;
    for (const Given& item : list_items(map)) {
        places.push_back(place_of(study, item->text));
        if (places.back() < study.columns.size()) continue;
        throw InputError(fmt::format("the study has no column `{}`", item->text), whole(item),
                         did_you_mean(item->text, {study.columns.begin(), study.columns.end()},
                                      "its columns are " + listed(study.columns)));
    }
    if (places.size() == 2 || places.size() == 3) return places;
    throw InputError("two or three columns are wanted here", whole(map),
                     "X, Y and the colour Z; or X and Y for points");
}

/// Numbers of the summary, gathered row by row.
class Counts {
public:
    explicit Counts(const Study& study)
        : status_(place_of(study, status_column)),
          steps_(place_of(study, "steps")),
          energy_(place_of(study, "energy_error")) {}

    void see(const std::vector<double>& row) {
        const double status = row[status_];
        if (!(status >= 0 && status < static_cast<double>(rows_.size())))
            throw EnvironmentError(
                fmt::format("row {:.0f} of the study has no status", row.front()),
                "its file is damaged: remove its chunk, and run the study again");
        ++rows_[static_cast<std::size_t>(status)];
        all_steps_ += row[steps_];
        if (energy_ >= row.size() || !(std::abs(row[energy_]) > worst_)) return;
        worst_ = std::abs(row[energy_]);
        row_of_worst_ = row.front();
    }

    /// Returns `990 ok, 10 not_converged`.
    [[nodiscard]] std::string statuses() const {
        std::vector<std::string> words;
        for (std::size_t k = 0; k < rows_.size(); ++k)
            if (rows_[k] > 0) words.push_back(fmt::format("{} {}", rows_[k], row_statuses[k]));
        return fmt::format("{}", fmt::join(words, ", "));
    }
    [[nodiscard]] double steps() const { return all_steps_; }
    [[nodiscard]] std::optional<std::string> energy() const {
        if (worst_ < 0) return {};
        return fmt::format("largest error {:.2e}, in row {:.0f}", worst_, row_of_worst_);
    }

private:
    std::size_t status_, steps_, energy_;
    std::array<std::int64_t, row_statuses.size()> rows_{};
    double all_steps_ = 0, worst_ = -1, row_of_worst_ = 0;
};

std::string summary_of(const Study& study, const Counts& counts, const EnsembleOptions& options) {
    std::string text = fmt::format("study        {}\nrows         {}: {}\nsteps        {:.10g}\n",
                                   study.title, study.rows, counts.statuses(), counts.steps());
    if (const int sweeps = options.wishes.sweeps.choice; sweeps > 0)
        text += fmt::format("sweeps       {}\n", sweeps_text(sweeps));
    if (const auto energy = counts.energy()) text += fmt::format("energy       {}\n", *energy);
    if (!options.random.empty()) text += fmt::format("seed         {}\n", options.seed);
    return text +
           fmt::format("table        hvi-gen collect {}\n", shell_word(study.directory.string()));
}

}  // namespace

void check_map(const Study& study, const Given& map) {
    if (map) static_cast<void>(columns_of(study, map));
}

void write_results(const Study& study, const EnsembleOptions& options) {
    if (const std::size_t missing = missing_chunks(study).size(); missing > 0) {
        std::fputs(
            fmt::format("note: other workers compute {} of {} chunks; the same command shows "
                        "the summary when they are done\n",
                        missing, study.chunks())
                .c_str(),
            stderr);
        return;
    }
    tidy(study);
    Counts counts(study);
    MapPicture map{.title = study.title, .x = {}, .y = {}, .z = {}, .values = {}};
    std::vector<std::size_t> places;
    if (options.map) places = columns_of(study, options.map);
    for_each_row(study, [&](const std::vector<double>& row) {
        counts.see(row);
        for (const std::size_t place : places) map.values.push_back(row[place]);
    });
    if (!places.empty()) {
        map.x = study.columns[places[0]];
        map.y = study.columns[places[1]];
        if (places.size() == 3) map.z = study.columns[places[2]];
        write_file(study.directory / "map.svg", draw(map));
    }
    const std::string summary = summary_of(study, counts, options);
    write_file(study.directory / "summary.txt", summary);
    write_standard_output(summary);
}

}  // namespace hvi::gen
