// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/compiler.hpp"

#include <sys/stat.h>

#include <cstdlib>
#include <iterator>
#include <optional>
#include <sstream>

#include "generator/support/child.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* help_on_compilers = "CXX names the compiler: CXX=g++ hvi-gen run kepler";
constexpr const char* help_on_mpi =
    "install an MPI, of Debian libopenmpi-dev and openmpi-bin, or let MPICXX name its compiler";
constexpr const char* help_on_cuda =
    "install the CUDA toolkit, or let NVCC name its compiler: NVCC=/usr/local/cuda/bin/nvcc";

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

/// A compiler as the user knows it.
struct CompilerNames {
    const char *variable, *command, *what, *help;
};

/// Returns the answer of a compiler to an option; empty where it cannot be started.
std::optional<ChildResult> answer_of(const Compiler& compiler, const char* option) {
    std::vector<std::string> question = compiler.command;
    question.emplace_back(option);
    try {
        return run_child(question, ".");
    } catch (const EnvironmentError&) { return {}; }
}

Compiler compiler_of(const CompilerNames& names) {
    const char* variable = std::getenv(names.variable);
    const std::string named = variable == nullptr ? "" : variable;
    Compiler compiler{words_of(named), {}};
    if (compiler.command.empty()) compiler.command.emplace_back(names.command);
    // NOTE: the compiler is called in another directory.
    if (std::string& first = compiler.command.front(); first.find('/') != std::string::npos)
        first = std::filesystem::absolute(first).string();
    const std::optional<ChildResult> answer = answer_of(compiler, "--version");
    if (!answer || !answer->ok())
        throw EnvironmentError(std::string("there is no ") + names.what + ": `" +
                                   joined(compiler.command) + " --version` fails",
                               names.help);
    compiler.version = first_line(answer->output);
    return compiler;
}

}  // namespace

Compiler find_compiler() { return compiler_of({"CXX", "c++", "C++ compiler", help_on_compilers}); }

Compiler find_mpi_compiler() {
    Compiler compiler = compiler_of({"MPICXX", "mpicxx", "compiler of MPI", help_on_mpi});
    // NOTE: --version asks the compiler behind it, which may be the same for several MPIs.
    if (const std::optional<ChildResult> shown = answer_of(compiler, "-show"); shown && shown->ok())
        compiler.version += "\n" + first_line(shown->output);
    return compiler;
}

Compiler find_device_compiler() {
    Compiler compiler = compiler_of({"NVCC", "nvcc", "compiler of CUDA", help_on_cuda});
    // NOTE: the first line is the name alone.
    if (const std::optional<ChildResult> all = answer_of(compiler, "--version"); all && all->ok())
        compiler.version = all->output;
    return compiler;
}

std::vector<std::string> compiler_options(Artifact artifact) {
    // NOTE: without a kind of card, nvcc writes for the oldest one that it knows, and the driver
    // makes that fit the card, and keeps it.
    if (artifact == Artifact::device_library)
        return {"-std=c++17", "-O3", "-I.", "-shared", "-Xcompiler", "-fPIC", "-x", "cu"};
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
