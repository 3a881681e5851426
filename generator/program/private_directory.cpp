// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/private_directory.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_make(const fs::path& directory, int error) {
    throw EnvironmentError("cannot make the directory " + directory.string() + ": " +
                               std::generic_category().message(error),
                           "compiled programs are kept below XDG_CACHE_HOME");
}

/// Whether an owner is the user or the system. NOTE: in a user namespace the system may have
/// another number than 0. The owner of `/` can put anything anywhere.
bool is_trusted(uid_t owner) {
    struct stat root {};
    return owner == 0 || owner == ::geteuid() || (::stat("/", &root) == 0 && owner == root.st_uid);
}

constexpr mode_t of_others = S_IRWXG | S_IRWXO, writing_of_others = S_IWGRP | S_IWOTH;

}  // namespace

std::optional<std::string> why_not_safe(const fs::path& directory) {
    for (fs::path at = directory;; at = at.parent_path()) {
        struct stat found {};
        if (::lstat(at.c_str(), &found) == 0 && S_ISDIR(found.st_mode)) {
            if (!is_trusted(found.st_uid)) return at.string() + " belongs to another user";
            if ((found.st_mode & writing_of_others) != 0 && (found.st_mode & S_ISVTX) == 0)
                return "others may write to " + at.string();
        }
        if (at == at.root_path()) return {};
    }
}

std::optional<std::string> why_not_private(const fs::path& directory) {
    struct stat found {};
    if (::lstat(directory.c_str(), &found) != 0) return "it cannot be looked at";
    if (S_ISLNK(found.st_mode)) return "it is a symbolic link";
    if (!S_ISDIR(found.st_mode)) return "it is no directory";
    if (found.st_uid != ::geteuid()) return "it belongs to another user";
    if ((found.st_mode & writing_of_others) != 0) return "others may write to it";
    if ((found.st_mode & of_others) != 0) return "others may look into it";
    return why_not_safe(directory.parent_path());
}

void make_private_directories(const fs::path& directory) {
    std::error_code ignored;
    if (fs::is_directory(directory, ignored)) return;
    if (directory.has_relative_path()) make_private_directories(directory.parent_path());
    if (::mkdir(directory.c_str(), S_IRWXU) != 0 && errno != EEXIST) cannot_make(directory, errno);
}

FreshDirectory::FreshDirectory(const fs::path& above, const std::string& name) {
    std::string path = (above / (name + "-XXXXXX")).string();
    if (::mkdtemp(path.data()) == nullptr) cannot_make(path, errno);
    path_ = path;
}

FreshDirectory::~FreshDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace hvi::gen
