// Compiled programs, kept from one run to the next.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/program/cache_directory.hpp"
#include "generator/program/compiler.hpp"

namespace hvi::gen {

/// A program or library as text. It may include its own headers, the runtime, <hvi/...>, and the
/// drivers, <driver/...>.
struct ProgramText {
    std::string main;
    std::map<std::string, std::string> headers;  ///< by the names under which it includes them
    std::vector<std::string> libraries = {};     ///< libraries to link: `gsl`
    Artifact artifact = Artifact::program;

    friend bool operator==(const ProgramText&, const ProgramText&) = default;
};

/// Returns the path of the compiled program in the cache. It is compiled unless the cache has it,
/// made of an equal text by this compiler for this machine. It is compiled again, with a warning,
/// where its digest shows that it has changed. A program appears in the cache whole. Throws
/// EnvironmentError, also where the compiler fails, and Interruption. Several threads may call it,
/// with different texts, and several processes.
[[nodiscard]] std::filesystem::path
built_program(const CacheDirectory& cache, const Compiler& compiler, const ProgramText& text);

/// Returns the path of the program if it is compiled already.
[[nodiscard]] std::optional<std::filesystem::path>
kept_program(const CacheDirectory& cache, const Compiler& compiler, const ProgramText& text);

}  // namespace hvi::gen
