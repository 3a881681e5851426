// The user's C++ compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hvi::gen {

struct Compiler {
    std::vector<std::string> command;  ///< CXX of the environment, a path or words; else c++
    std::string version;               ///< the first line of what `--version` prints
};

/// Throws EnvironmentError where there is none.
[[nodiscard]] Compiler find_compiler();

/// Kinds of files that the compiler makes.
enum class Artifact { program, library };

/// What is compiled with: as users do who care for speed.
[[nodiscard]] std::vector<std::string> compiler_options(Artifact artifact);

/// Makes of `main.cpp` in the directory, which may include what lies there, the file `program`
/// beside it, linked with the libraries: a program, or a library that programs load. Throws
/// EnvironmentError with the first error of the compiler, and where there is no such file then.
void compile(const Compiler& compiler, const std::filesystem::path& directory,
             const std::vector<std::string>& libraries = {}, Artifact artifact = Artifact::program);

}  // namespace hvi::gen
