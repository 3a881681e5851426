// A study directory: the rows of an ensemble in chunks, which any number of workers compute.
// SPDX-License-Identifier: GPL-2.0-or-later
//
//     DIR/study.toml              the study, written by whoever begins it
//     DIR/chunks/000/000012.npy   rows of a chunk, written whole
//     DIR/chunks/000/000012.part  its first rows, where a worker was told to stop
//     DIR/chunks/000/000012.lock  a worker computes it
//
// A row is a function of the study and its number alone, so that a chunk has the same bytes whoever
// computes it, and however often.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "generator/drive/row_file.hpp"

namespace hvi::gen {

/// The facts of a study that all its workers share.
struct Study {
    std::filesystem::path directory;
    std::string title;    ///< `ensemble of kepler, gauss:4`
    std::string command;  ///< begins it, and goes on with it
    std::string key;      ///< identifies all that its rows depend on
    std::int64_t rows = 0;
    std::int64_t rows_in_chunk = 1;
    std::vector<std::string> columns;

    [[nodiscard]] std::int64_t chunks() const { return (rows + rows_in_chunk - 1) / rows_in_chunk; }
    [[nodiscard]] std::int64_t first_row(std::int64_t chunk) const { return chunk * rows_in_chunk; }
    [[nodiscard]] std::int64_t rows_of(std::int64_t chunk) const {
        return std::min(rows_in_chunk, rows - first_row(chunk));
    }
    /// The number of chunks whose files share a directory.
    static constexpr std::int64_t in_directory = 1000;

    /// Returns the path of a file of a chunk: ending `npy`, `part` or `lock`.
    [[nodiscard]] std::filesystem::path file(std::int64_t chunk, const char* ending) const;
};

/// The name of the column with the number among `row_statuses`.
inline constexpr const char* status_column = "status";

/// Begins a study in its directory, or goes on with it. Throws EnvironmentError where the directory
/// cannot be written to, and where another study is in it.
void begin(const Study& study);

/// Reads the study in a directory. Throws InputError where there is none, and where its file is
/// damaged.
[[nodiscard]] Study study_in(const std::filesystem::path& directory);

/// Returns the columns of its tables: words of statuses where a format has words.
[[nodiscard]] TableHead head_of(const Study& study);

/// Whether the rows of a chunk are there.
[[nodiscard]] bool is_done(const Study& study, std::int64_t chunk);

/// Returns which chunks of a directory are done, its first one first. NOTE: one look at a directory
/// costs a file system on a network far less than a thousand looks at files.
[[nodiscard]] std::vector<bool> done_in(const Study& study, std::int64_t directory);

/// Removes what killed workers have left. Precondition: all chunks are done.
void tidy(const Study& study);

/// Writes rows of a chunk whole. Throws EnvironmentError.
void write_rows(const Study& study, const std::filesystem::path& file,
                const std::vector<std::vector<double>>& rows);

/// Reads the rows of a chunk, or its first ones. Returns none where the file is missing. Throws
/// EnvironmentError where it is damaged.
[[nodiscard]] std::vector<std::vector<double>> read_rows(const Study& study,
                                                         const std::filesystem::path& file);

}  // namespace hvi::gen
