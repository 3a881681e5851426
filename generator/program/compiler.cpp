// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/compiler.hpp"

#include <sys/stat.h>

#include <cstdlib>
#include <iterator>
#include <sstream>

#include "generator/support/child.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* help_on_compilers = "CXX names the compiler: CXX=g++ hvi-gen run kepler";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

/// Splits a command: `ccache g++` are two words, but the path of a file is one, also with blanks in
/// it.
std::vector<std::string> words_of(const std::string& command) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(command, ignored)) return {command};
    std::istringstream text(command);
    return {std::istream_iterator<std::string>(text), {}};
}

/// Returns the first line that says `error`, else the first line.
std::string first_error(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.find("error:") != std::string::npos) return line;
    return first_line(text);
}

}  // namespace

Compiler find_compiler() {
    const char* variable = std::getenv("CXX");
    const std::string named = variable == nullptr ? "" : variable;
    Compiler compiler{words_of(named), {}};
    if (compiler.command.empty()) compiler.command.emplace_back("c++");
    // NOTE: the compiler is called in another directory.
    if (std::string& first = compiler.command.front(); first.find('/') != std::string::npos)
        first = std::filesystem::absolute(first).string();

    std::vector<std::string> question = compiler.command;
    question.emplace_back("--version");
    try {
        const ChildResult answer = run_child(question, ".");
        compiler.version = first_line(answer.output);
        if (answer.ok()) return compiler;
    } catch (const EnvironmentError&) {}
    throw EnvironmentError("there is no C++ compiler: `" + joined(question) + "` fails",
                           help_on_compilers);
}

std::vector<std::string> compiler_options(Artifact artifact) {
    std::vector<std::string> options{"-std=c++17", "-O3", "-march=native", "-I."};
    if (artifact == Artifact::library) options.insert(options.end(), {"-shared", "-fPIC"});
    return options;
}

void compile(const Compiler& compiler, const std::filesystem::path& directory,
             const std::vector<std::string>& libraries, Artifact artifact) {
    std::vector<std::string> words = compiler.command;
    const std::vector<std::string> options = compiler_options(artifact);
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"main.cpp", "-o", "program"});
    for (const std::string& library : libraries) words.push_back("-l" + library);
    const ChildResult result = run_child(words, directory);
    if (!result.ok())
        throw EnvironmentError("the compiler failed: " +
                                   first_error(result.errors + "\n" + result.output),
                               "it was called as " + joined(words));
    struct stat made {};
    if (::lstat((directory / "program").c_str(), &made) != 0 || !S_ISREG(made.st_mode) ||
        (made.st_mode & S_IXUSR) == 0)
        throw EnvironmentError("the compiler has made no program",
                               "it was called as " + joined(words));
}

}  // namespace hvi::gen
