// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/cache_content.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <tuple>

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr const char* prefix_of_unfinished = "new-";

/// Whether the name is one of built_program(): 16 hexadecimal digits.
bool is_program(const std::string& name) {
    return name.size() == 16 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::uintmax_t bytes_in(const fs::path& directory) {
    std::uintmax_t sum = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator at(directory, error), end; !error && at != end;
         at.increment(error)) {
        std::error_code gone;
        const std::uintmax_t size = at->is_regular_file(gone) ? at->file_size(gone) : 0;
        if (!gone) sum += size;
    }
    return sum;
}

/// Removes a program. NOTE: renames it first, so that it is no program even if the removal is
/// interrupted.
void remove_program(const fs::path& directory) {
    const fs::path doomed =
        directory.parent_path() / (prefix_of_unfinished + directory.filename().string());
    std::error_code error;
    fs::rename(directory, doomed, error);
    fs::remove_all(error ? directory : doomed, error);
}

}  // namespace

std::uintmax_t CacheContent::bytes() const {
    std::uintmax_t sum = 0;
    for (const Program& program : programs) sum += program.bytes;
    return sum;
}

CacheContent content_of(const fs::path& cache) {
    CacheContent content;
    std::error_code error;
    for (fs::directory_iterator at(cache, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename();
        std::error_code ignored;
        if (!fs::is_directory(at->symlink_status(ignored))) continue;
        if (name.starts_with(prefix_of_unfinished)) content.unfinished.push_back(at->path());
        if (!is_program(name)) continue;
        std::error_code damaged;
        auto used = fs::last_write_time(at->path() / "key", damaged);
        if (damaged) used = fs::file_time_type::min();
        content.programs.push_back({at->path(), bytes_in(at->path()), used});
    }
    std::sort(content.programs.begin(), content.programs.end(), [](const auto& a, const auto& b) {
        return std::tie(a.used, a.directory) < std::tie(b.used, b.directory);
    });
    return content;
}

void mark_used(const fs::path& program_directory) {
    std::error_code ignored;  // of a file system that is only read
    fs::last_write_time(program_directory / "key", fs::file_time_type::clock::now(), ignored);
}

void tidy(const fs::path& cache, std::uintmax_t most_bytes) {
    const CacheContent content = content_of(cache);
    std::error_code ignored;
    for (const fs::path& each : content.unfinished) fs::remove_all(each, ignored);
    std::uintmax_t left = content.bytes();
    for (const CacheContent::Program& program : content.programs) {
        if (left <= most_bytes) return;
        remove_program(program.directory);
        left -= program.bytes;
    }
}

}  // namespace hvi::gen
