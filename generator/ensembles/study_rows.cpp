// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/study_rows.hpp"

#include <fmt/format.h>

#include "generator/support/bar.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

std::vector<std::int64_t> missing_chunks(const Study& study) {
    std::vector<std::int64_t> missing;
    std::vector<bool> done;
    for (std::int64_t chunk = 0; chunk < study.chunks(); ++chunk) {
        const std::int64_t place = chunk % Study::in_directory;
        if (place == 0) done = done_in(study, chunk / Study::in_directory);
        if (!done[static_cast<std::size_t>(place)]) missing.push_back(chunk);
    }
    return missing;
}

void for_each_row(const Study& study, const std::function<void(const std::vector<double>&)>& see) {
    Bar bar;
    for (std::int64_t chunk = 0; chunk < study.chunks(); ++chunk) {
        if (!is_done(study, chunk)) continue;
        const std::filesystem::path file = study.file(chunk, "npy");
        const std::vector<std::vector<double>> rows = read_rows(study, file);
        if (static_cast<std::int64_t>(rows.size()) != study.rows_of(chunk))
            throw EnvironmentError(fmt::format("{} has {} rows, not {}", file.string(), rows.size(),
                                               study.rows_of(chunk)),
                                   "remove it, and run the study again");
        for (const std::vector<double>& row : rows) see(row);
        bar.show(static_cast<double>(chunk + 1) / static_cast<double>(study.chunks()));
    }
}

}  // namespace hvi::gen
