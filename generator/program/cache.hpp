// Compiled programs, kept from one run to the next.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "generator/program/compiler.hpp"

namespace hvi::gen {

/// A program as text. Besides its own headers it may include the runtime, <hvi/...>, and the
/// drivers, <driver/...>.
struct ProgramText {
    std::string main;
    std::map<std::string, std::string> headers;  ///< by the names under which it includes them
    std::vector<std::string> libraries = {};     ///< that it is linked with: `gsl`

    friend bool operator==(const ProgramText&, const ProgramText&) = default;
};

/// Where the compiled program is: in hvi-gen/ of XDG_CACHE_HOME, else of .cache in HOME, else of
/// the directory for temporary files. It is compiled where it is not there already, made of the
/// same text by the same compiler for the same machine. A program appears there whole. Throws
/// EnvironmentError, also where the compiler fails, and Interruption. Several threads may call it,
/// with different texts.
[[nodiscard]] std::filesystem::path built_program(const Compiler& compiler,
                                                  const ProgramText& text);

}  // namespace hvi::gen
