// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/cache_directory.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <system_error>

#include "generator/program/cache_content.hpp"
#include "generator/support/error.hpp"
#include "generator/support/warning.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr const char* help_on_places =
    "XDG_CACHE_HOME may name a directory of yours, below which compiled programs are kept";

/// Resolves links, as far as the path exists.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    fs::path result = fs::weakly_canonical(fs::absolute(path), error);
    if (error)
        throw EnvironmentError("cannot look at " + path.string() + ": " + error.message(),
                               help_on_places);
    return result;
}

fs::path temporary_directory() {
    std::error_code error;
    const fs::path directory = fs::temp_directory_path(error);
    if (error)
        throw EnvironmentError(
            fmt::format("there is no directory for temporary files: {}", error.message()),
            "TMPDIR names it; with HOME or XDG_CACHE_HOME compiled programs are kept there");
    return resolved(directory);
}

fs::path usual_place() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value == nullptr ? "" : value);
    };
    // NOTE: as the specification of these directories wants it, relative paths are left out.
    if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute())
        return cache / "hvi-gen";
    if (const fs::path home = variable("HOME"); home.is_absolute())
        return home / ".cache" / "hvi-gen";
    return temporary_directory() / fmt::format("hvi-gen-{}", ::geteuid());
}

/// Closes the directory to readers. Earlier versions let others read it, but only the user could
/// write.
void close_to_readers(const fs::path& directory) {
    constexpr mode_t readable = 0755;
    struct stat found {};
    if (::lstat(directory.c_str(), &found) == 0 && S_ISDIR(found.st_mode) &&
        found.st_uid == ::geteuid() && (found.st_mode & 07777U & ~readable) == 0)
        ::chmod(directory.c_str(), S_IRWXU);
}

}  // namespace

CacheDirectory::CacheDirectory() {
    const fs::path place = usual_place();
    fs::path above = resolved(place.parent_path());
    std::optional<std::string> reason = why_not_safe(above);
    if (!reason) {
        make_private_directories(above);
        above = resolved(above);  // NOTE: others may have been faster where they may write
        path_ = above / place.filename();
        make_private_directories(path_);
        close_to_readers(path_);
        reason = why_not_private(path_);
    }
    if (!reason) {
        lock_.emplace(path_);
        if (lock_->try_alone()) tidy(path_, most_bytes_of_cache);
        lock_->share();
        return;
    }
    const fs::path temporary = temporary_directory();
    if (const auto unsafe = why_not_safe(temporary))
        throw EnvironmentError("compiled programs could be replaced by those of others: " + *unsafe,
                               help_on_places);
    path_ = fresh_.emplace(temporary, "hvi-gen").path();
    warn(fmt::format("compiled programs are not kept in {}: {}", place.string(), *reason),
         "they are kept, and looked for, only where nobody else can put any: in a directory of "
         "yours of mode 0700");
}

void CacheDirectory::clear() {
    if (!lock_) return;  // there is nothing yet
    if (!lock_->try_alone())
        throw EnvironmentError("another hvi-gen uses the programs in " + path_.string(),
                               "wait until it has ended");
    tidy(path_, 0);
    lock_->share();
}

}  // namespace hvi::gen
