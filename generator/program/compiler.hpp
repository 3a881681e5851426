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

/// What programs are compiled with: as users do who care for speed.
[[nodiscard]] const std::vector<std::string>& compiler_options();

/// Makes of `main.cpp` in the directory, which may include what lies there, the program `program`
/// beside it, linked with the libraries. Throws EnvironmentError with the first error of the
/// compiler, and where there is no program then.
void compile(const Compiler& compiler, const std::filesystem::path& directory,
             const std::vector<std::string>& libraries = {});

}  // namespace hvi::gen
