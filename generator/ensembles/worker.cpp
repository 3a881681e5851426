// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/worker.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

namespace hvi::gen {

namespace {

/// Computes the rows of a chunk that are missing. Returns whether all of them are there.
bool complete(const Study& study, std::int64_t chunk, const ComputeRows& compute,
              const std::function<void(std::int64_t)>& on_rows,
              std::vector<std::vector<double>>& rows) {
    const std::int64_t first = study.first_row(chunk), count = study.rows_of(chunk);
    for (auto there = static_cast<std::int64_t>(rows.size()); there < count;) {
        std::vector<std::vector<double>> more = compute(first + there, count - there);
        if (more.empty()) return false;
        const auto size = static_cast<std::int64_t>(more.size());
        std::move(more.begin(), more.end(), std::back_inserter(rows));
        there += size;
        on_rows(size);
    }
    return true;
}

}  // namespace

bool compute_chunk(const Study& study, std::int64_t chunk, const ComputeRows& compute,
                   const std::function<void(std::int64_t)>& on_rows) {
    const std::filesystem::path part = study.file(chunk, "part");
    std::vector<std::vector<double>> rows = read_rows(study, part);
    const bool is_whole = complete(study, chunk, compute, on_rows, rows);
    if (is_whole || !rows.empty())
        write_rows(study, is_whole ? study.file(chunk, "npy") : part, rows);
    if (!is_whole) return false;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    return true;
}

}  // namespace hvi::gen
