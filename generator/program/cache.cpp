// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/cache.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "generator/program/embedded.hpp"
#include "generator/program/machine.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

fs::path cache_directory() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value == nullptr ? "" : value);
    };
    // NOTE: as the specification of these directories wants it, relative paths are left out.
    if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute())
        return cache / "hvi-gen";
    if (const fs::path home = variable("HOME"); home.is_absolute())
        return home / ".cache" / "hvi-gen";
    return fs::temp_directory_path() / fmt::format("hvi-gen-{}", ::getuid());
}

using Files = std::map<std::string, std::string_view>;  // by their paths in the directory

Files files_of(const ProgramText& text) {
    Files files{{"main.cpp", text.main}};
    for (const auto& [name, content] : text.headers) files.emplace(name, content);
    for (const EmbeddedFile& file : embedded_runtime())
        files.emplace("hvi/" + std::string(file.name), file.text);
    for (const EmbeddedFile& file : embedded_drivers())
        files.emplace("driver/" + std::string(file.name), file.text);
    return files;
}

/// All that the program depends on.
std::string key_of(const Compiler& compiler, const ProgramText& text, const Files& files) {
    const Machine machine = this_machine();
    std::string key = compiler.version + "\n" + machine.processor + "\n" + machine.extensions;
    for (const std::string& word : compiler.command) key += "\n" + word;
    for (const std::string& word : compiler_options()) key += "\n" + word;
    for (const std::string& library : text.libraries) key += "\n-l" + library;
    for (const auto& [name, content] : files)
        key.append("\n").append(name).append("\n").append(content);
    return key;
}

/// FNV-1a. NOTE: it only names a directory; the key that lies in it is compared.
std::string hash(std::string_view text) {
    std::uint64_t value = 0xcbf29ce484222325U;
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return fmt::format("{:016x}", value);
}

bool holds(const fs::path& file, std::string_view text) {
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    return content.str() == text;
}

void make_directories(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error)
        throw EnvironmentError("cannot make the directory " + path.string() + ": " +
                                   error.message(),
                               "compiled programs are kept below XDG_CACHE_HOME");
}

/// A directory that is removed at the end of its life unless renamed.
class Workshop {
public:
    explicit Workshop(fs::path path) : path_(std::move(path)) { make_directories(path_); }
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

}  // namespace

fs::path built_program(const Compiler& compiler, const ProgramText& text) {
    const Files files = files_of(text);
    const std::string key = key_of(compiler, text, files);
    const fs::path directory = cache_directory() / hash(key);
    const fs::path program = directory / "program";
    if (holds(directory / "key", key) && fs::exists(program)) return program;

    const Workshop workshop(cache_directory() / fmt::format("new-{}-{}", ::getpid(), hash(key)));
    for (const auto& [name, content] : files) {
        make_directories((workshop.path() / name).parent_path());
        write_file(workshop.path() / name, content);
    }
    compile(compiler, workshop.path(), text.libraries);
    write_file(workshop.path() / "key", key);
    std::error_code error;
    fs::rename(workshop.path(), directory, error);
    if (!error) return program;
    // NOTE: another hvi-gen may have been faster; else something else has this name.
    if (holds(directory / "key", key) && fs::exists(program)) return program;
    fs::remove_all(directory, error);
    fs::rename(workshop.path(), directory, error);
    if (error) throw EnvironmentError("cannot make " + directory.string() + ": " + error.message());
    return program;
}

}  // namespace hvi::gen
