// Starting processes, and temporary directories.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/program/cli/program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tests/checkout.hpp"

namespace hvi::test {

namespace fs = std::filesystem;

namespace {

void redirect(int stream, const fs::path& file) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (opened < 0 || ::dup2(opened, stream) < 0) ::_exit(126);
    ::close(opened);
}

/// Leaves out the lines `hvi-gen: STAGE (N s)` that a slow machine, or a sanitizer, brings about.
std::string without_progress(const std::string& text) {
    static const std::regex progress("hvi-gen: [^\n]* \\([0-9]+ s\\)\n");
    return std::regex_replace(text, progress, "");
}

Outcome run(std::vector<std::string> words, const fs::path& directory) {
    const Directory streams;
    const fs::path out = streams / "out";
    const fs::path err = streams / "err";
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
        redirect(STDOUT_FILENO, out);
        redirect(STDERR_FILENO, err);
        if (::chdir(directory.c_str()) == 0) ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, contents(out), without_progress(contents(err))};
}

}  // namespace

Outcome hvi_gen(const std::vector<std::string>& words, const fs::path& directory) {
    std::vector<std::string> all = {hvi_gen_program()};
    all.insert(all.end(), words.begin(), words.end());
    return run(std::move(all), directory);
}

Outcome shell(const std::string& line, const fs::path& directory) {
    const std::string function = "hvi_gen=$1; hvi-gen() { \"$hvi_gen\" \"$@\"; }; ";
    return run({"/bin/bash", "-c", function + line, "bash", hvi_gen_program()}, directory);
}

Directory::Directory() {
    std::string name = (fs::temp_directory_path() / "hvi-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    path_ = name;
}

Directory::~Directory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::vector<std::string> names_in(const fs::path& directory) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace hvi::test
