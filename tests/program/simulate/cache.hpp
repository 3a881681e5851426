// Where tests of `run` and `report` keep what they compile.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/program/cli/program.hpp"

namespace hvi::test {

/// From now on programs are kept in a directory that is removed with the last test.
inline void use_cache() {
    struct Cache {
        Directory directory;
        Cache() { ::setenv("XDG_CACHE_HOME", directory.path().c_str(), 1); }
    };
    static const Cache cache;
}

/// The compiler that the tests were given, for a script around it. NOTE: a path may have blanks.
inline std::string compiler_of_tests() {
    const char* variable = std::getenv("CXX");
    const std::string named = variable == nullptr ? "c++" : variable;
    return std::filesystem::exists(named) ? "'" + named + "'" : named;
}

}  // namespace hvi::test
