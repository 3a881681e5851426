// Running hvi-gen as a user does, and looking at what comes out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hvi::test {

struct Outcome {
    int status = -1;  ///< the exit status, or 128 and the number of the signal as in a shell
    std::string out;
    std::string err;  ///< without the words about progress
};

/// Runs hvi-gen with these words, in the directory when one is given.
[[nodiscard]] Outcome hvi_gen(const std::vector<std::string>& words,
                              const std::filesystem::path& directory = ".");

/// Runs a line of shell in which `hvi-gen` is the program: for redirections.
[[nodiscard]] Outcome shell(const std::string& line, const std::filesystem::path& directory = ".");

/// Returns the names of the files in a directory, sorted.
[[nodiscard]] std::vector<std::string> names_in(const std::filesystem::path& directory);

/// A new directory, removed with all that is in it at the end of the scope.
class Directory {
public:
    Directory();
    ~Directory();
    Directory(const Directory&) = delete;
    Directory& operator=(const Directory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }
    [[nodiscard]] std::vector<std::string> names() const { return names_in(path_); }

private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string contents(const std::filesystem::path& file);
void write(const std::filesystem::path& file, const std::string& text);
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

}  // namespace hvi::test
