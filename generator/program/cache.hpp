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

/// A program or library as text. Besides its own headers it may include the runtime, <hvi/...>, and
/// the drivers, <driver/...>.
struct ProgramText {
    std::string main;
    std::map<std::string, std::string> headers;  ///< by the names under which it includes them
    std::vector<std::string> libraries = {};     ///< that it is linked with: `gsl`
    Artifact artifact = Artifact::program;

    friend bool operator==(const ProgramText&, const ProgramText&) = default;
};

/// Where the compiled program is, in the directory. It is compiled where it is not there already,
/// made of the same text by the same compiler for the same machine; also, with a warning, where it
/// is no longer what was compiled, by its digest. A program appears there whole. Throws
/// EnvironmentError, also where the compiler fails, and Interruption. Several threads may call it,
/// with different texts, and several processes.
[[nodiscard]] std::filesystem::path
built_program(const CacheDirectory& cache, const Compiler& compiler, const ProgramText& text);

/// The same where it is compiled already.
[[nodiscard]] std::optional<std::filesystem::path>
kept_program(const CacheDirectory& cache, const Compiler& compiler, const ProgramText& text);

}  // namespace hvi::gen
