// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/cache.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "generator/program/cache_content.hpp"
#include "generator/program/embedded.hpp"
#include "generator/program/machine.hpp"
#include "generator/support/digest.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/warning.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string_view>;  // by their paths in the directory

Files files_of(const ProgramText& text) {
    Files files{{"main.cpp", text.main}};
    for (const auto& [name, content] : text.headers) files.emplace(name, content);
    for (const EmbeddedFile& file : embedded_headers()) files.emplace(file.name, file.text);
    return files;
}

/// Returns all that the program depends on. NOTE: the first line is the version of the entries'
/// layout.
std::string key_of(const Compiler& compiler, const ProgramText& text, const Files& files) {
    const Machine machine = this_machine();
    std::string key = "program and key\n" + compiler.version + "\n" + machine.processor + "\n" +
                      machine.extensions;
    for (const std::string& word : compiler.command) key += "\n" + word;
    for (const std::string& word : compiler_options(text.artifact)) key += "\n" + word;
    for (const std::string& library : text.libraries) key += "\n-l" + library;
    for (const auto& [name, content] : files)
        key.append("\n").append(name).append("\n").append(content);
    return key;
}

std::string content(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Whether a file or directory of this kind exists and belongs to the user.
bool is_own(const fs::path& path, mode_t type) {
    struct stat found {};
    return ::lstat(path.c_str(), &found) == 0 && (found.st_mode & S_IFMT) == type &&
           found.st_uid == ::geteuid() && (found.st_mode & S_IXUSR) != 0;
}

/// A directory with a program and its key.
class Entry {
public:
    Entry(fs::path directory, std::string key)
        : directory_(std::move(directory)), key_(std::move(key)) {}

    [[nodiscard]] const fs::path& directory() const { return directory_; }
    [[nodiscard]] fs::path program() const { return directory_ / "program"; }
    [[nodiscard]] bool is_there() const {
        std::error_code ignored;
        return fs::exists(fs::symlink_status(directory_, ignored));
    }

    /// Whether the program is unchanged.
    [[nodiscard]] bool is_sound() const {
        std::error_code ignored;
        return is_own(directory_, S_IFDIR) && is_own(program(), S_IFREG) &&
               fs::is_regular_file(directory_ / "key", ignored) &&
               content(directory_ / "key") == sealed(program());
    }

    /// Moves a directory with a program here. That directory is then gone, or has the former
    /// contents.
    void take(const fs::path& made) const {
        write_file(made / "key", sealed(made / "program"));
        std::error_code error;
        fs::rename(made, directory_, error);
        // NOTE: another hvi-gen may have been faster. Otherwise the entry here is damaged. It must
        // not be missing at any time: another hvi-gen may be about to start a program that a third
        // one has repaired.
        if (!error || is_sound() ||
            ::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, directory_.c_str(), RENAME_EXCHANGE) == 0)
            return;
        fs::remove_all(directory_, error);  // where the file system cannot exchange them
        fs::rename(made, directory_, error);
        if (error)
            throw EnvironmentError("cannot make " + directory_.string() + ": " + error.message());
    }

private:
    /// Returns the key with the digest of a program.
    [[nodiscard]] std::string sealed(const fs::path& program) const {
        const std::string text = content(program);
        return fmt::format("{}\nprogram of {} bytes: {}\n", key_, text.size(), digest(text));
    }

    fs::path directory_;
    std::string key_;
};

/// Makes the program in the directory, without its sources.
void make_program(const Compiler& compiler, const fs::path& directory, const Files& files,
                  const ProgramText& text) {
    const FreshDirectory sources(directory, "of");
    for (const auto& [name, content] : files) {
        make_private_directories((sources.path() / name).parent_path());
        write_file(sources.path() / name, content);
    }
    compile(compiler, sources.path(), text.libraries, text.artifact);
    std::error_code error;
    fs::rename(sources.path() / "program", directory / "program", error);
    if (error)
        throw EnvironmentError("cannot make " + (directory / "program").string() + ": " +
                               error.message());
}

}  // namespace

std::optional<fs::path> kept_program(const CacheDirectory& cache, const Compiler& compiler,
                                     const ProgramText& text) {
    const std::string key = key_of(compiler, text, files_of(text));
    const Entry entry(cache.path() / digest(key), key);
    if (!entry.is_sound()) return {};
    mark_used(entry.directory());
    return entry.program();
}

fs::path built_program(const CacheDirectory& cache, const Compiler& compiler,
                       const ProgramText& text) {
    const Files files = files_of(text);
    const std::string key = key_of(compiler, text, files);
    const Entry entry(cache.path() / digest(key), key);
    if (entry.is_sound()) {
        mark_used(entry.directory());
        return entry.program();
    }
    if (entry.is_there()) warn(entry.program().string() + " is damaged, and compiled again");

    const FreshDirectory workshop(cache.path(), "new");
    make_program(compiler, workshop.path(), files, text);
    entry.take(workshop.path());
    return entry.program();
}

}  // namespace hvi::gen
