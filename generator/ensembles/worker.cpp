// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/worker.hpp"

#include <system_error>
#include <utility>

namespace hvi::gen {

namespace {

/// Computes the rows of a chunk that are missing. Returns whether all of them are there.
bool complete(const Study& study, std::int64_t chunk, const ComputeRow& compute,
              const std::function<void()>& on_row, std::vector<std::vector<double>>& rows) {
    const std::int64_t first = study.first_row(chunk), count = study.rows_of(chunk);
    while (static_cast<std::int64_t>(rows.size()) < count) {
        const auto number = first + static_cast<std::int64_t>(rows.size());
        std::optional<std::vector<double>> row = compute(number);
        if (!row) return false;
        rows.push_back(std::move(*row));
        on_row();
    }
    return true;
}

}  // namespace

bool compute_chunk(const Study& study, std::int64_t chunk, const ComputeRow& compute,
                   const std::function<void()>& on_row) {
    const std::filesystem::path part = study.file(chunk, "part");
    std::vector<std::vector<double>> rows = read_rows(study, part);
    const bool is_whole = complete(study, chunk, compute, on_row, rows);
    if (is_whole || !rows.empty())
        write_rows(study, is_whole ? study.file(chunk, "npy") : part, rows);
    if (!is_whole) return false;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    return true;
}

}  // namespace hvi::gen
