// Looking for an accuracy has an end, and what was found until then is kept.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;

namespace {

/// A planet that is near the sun for a millionth of its year, ten times: that takes more steps than
/// there is time for.
std::vector<std::string> near_the_sun(std::vector<std::string> words) {
    const std::vector<std::string> all{"kepler",     "--param", "ecc=0.9999", "--until", "20*pi",
                                       "--accuracy", "1e-6",    "--budget",   "2"};
    words.insert(words.end(), all.begin(), all.end());
    return words;
}

bool is_in(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a run to an accuracy that is not reached in time is kept, and says what it is") {
    use_cache();
    const Directory directory;
    const Outcome outcome =
        hvi_gen(near_the_sun({"run", "--only", "table,summary", "-o", "out"}), directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    const std::string shortfall = " is not reached in 2 s: the best so far is gauss:16 in steps of "
                                  "(20*pi)/";
    CHECK(is_in(outcome.err, "error: an error of 1e-06 at t = 62.8318530717958"));
    CHECK(is_in(outcome.err, shortfall));
    CHECK(is_in(outcome.err, "help: the run of these is in out; ask for less"));
    CHECK(directory.names() == std::vector<std::string>{"out"});
    CHECK(names_in(directory / "out") == std::vector<std::string>{"summary.txt", "trajectory.csv"});
    CHECK(is_in(contents(directory / "out/summary.txt"), shortfall));
}

TEST_CASE("a header for an accuracy that is not reached in time is not written") {
    use_cache();
    const Directory directory;
    const Outcome outcome = hvi_gen(near_the_sun({"stepper", "-o", "out.hpp"}), directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(is_in(outcome.err, " is not reached in 2 s: the best so far is gauss:16 in steps of "));
    CHECK(directory.names().empty());
}

TEST_CASE("a budget is of seconds, and of an accuracy") {
    for (const std::string budget : {"0", "-1", "1/2", "long"})
        CHECK(hvi_gen({"run", "kepler", "--accuracy", "1e-3", "--budget", budget}).status == 2);
    const Outcome alone = hvi_gen({"run", "kepler", "--budget", "5"});
    CHECK(alone.status == 2);
    CHECK(is_in(alone.err, "error: --budget goes with --accuracy\n"));
}
