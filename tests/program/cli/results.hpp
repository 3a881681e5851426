// Results of hvi-gen.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"

namespace hvi::test {

inline std::vector<std::string> with(std::vector<std::string> words,
                                     const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Returns the output of the words, which must have equal bytes every time.
inline std::string same_every_time(const std::vector<std::string>& words) {
    const Outcome first = hvi_gen(words);
    INFO(first.err);
    REQUIRE(first.status == 0);
    CHECK(first.err.empty());
    CHECK(!first.out.empty());
    for (int run = 0; run < 9; ++run) CHECK((hvi_gen(words).out == first.out));
    return first.out;
}

}  // namespace hvi::test
