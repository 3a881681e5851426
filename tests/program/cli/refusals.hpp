// Checks of every refusal of hvi-gen: its status, its message, and that nothing else is written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"

namespace hvi::test {

/// The text above the caret of a message, from the caret on as far as it is underlined.
inline std::string pointed_at(const std::string& message) {
    const auto lines = lines_of(message);
    if (lines.size() < 3 || lines[2].find('^') == std::string::npos) return "";
    const std::size_t begin = lines[2].find('^');
    return begin > lines[1].size() ? "" : lines[1].substr(begin, lines[2].size() - begin);
}

inline bool has_place(const std::string& message) {
    const auto lines = lines_of(message);
    return lines.size() > 2 && lines[2].find('^') != std::string::npos;
}

/// error: WHAT, then perhaps a place of two lines, then perhaps help: WHAT WOULD HELP.
inline void check_form(const std::string& message) {
    const auto lines = lines_of(message);
    REQUIRE(!lines.empty());
    std::size_t next = 1;
    CHECK(lines[0].rfind("error: ", 0) == 0);
    if (next < lines.size() && lines[next].rfind("  ", 0) == 0) {
        REQUIRE(lines.size() > next + 1);
        CHECK(lines[next + 1].find_first_not_of(' ') == lines[next + 1].find('^'));
        CHECK(lines[next + 1].find_first_not_of(" ^~") == std::string::npos);
        next += 2;
    }
    if (next < lines.size() && lines[next].rfind("help: ", 0) == 0) ++next;
    CHECK(next == lines.size());
    for (const std::string& line : lines) CHECK(line.size() < 700);
}

struct Refusal {
    int status;
    std::string place;  ///< the text under the caret; empty where it points to no text
    std::vector<std::string> words;
};

inline void check_refused(const Refusal& refusal, const std::vector<std::string>& words) {
    const Directory directory;
    write(directory / "old.hpp", "old");
    const Outcome outcome = hvi_gen(words, directory.path());
    std::string line;
    for (const std::string& word : words) line += word.substr(0, 200) + " | ";
    INFO(line << "\n" << outcome.err);
    CHECK(outcome.status == refusal.status);
    CHECK(outcome.out.empty());
    check_form(outcome.err);
    if (refusal.status == 2) CHECK(has_place(outcome.err));
    if (!refusal.place.empty()) CHECK(pointed_at(outcome.err) == refusal.place);
    CHECK(directory.names() == std::vector<std::string>{"old.hpp"});
    CHECK(contents(directory / "old.hpp") == "old");
}

/// A METHOD that is refused by `tableau` and by `stepper`, with a file of results and without.
inline void check_method_refused(const Refusal& refusal) {
    const std::vector<std::vector<std::string>> commands = {
        {"tableau"}, {"tableau", "-o", "old.hpp"}, {"stepper", "-o", "new.hpp"}};
    for (std::vector<std::string> words : commands) {
        words.insert(words.end(), refusal.words.begin(), refusal.words.end());
        check_refused(refusal, words);
    }
}

}  // namespace hvi::test
