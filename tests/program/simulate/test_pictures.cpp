// Pictures of `hvi-gen run` for scenes of any size: what they show, and of which numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"
#include "tests/program/simulate/table.hpp"

using namespace hvi::test;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

/// Names q and p with these indices. Each oscillates by itself and begins at `start`.
std::string swinging(const std::string& ranges, const std::string& indices, const std::string& sum,
                     const std::string& start) {
    const auto family = [&](const char* name) { return name + ("[" + ranges + "]"); };
    const auto element = [&](const char* name) { return name + ("[" + indices + "]"); };
    return "coordinates = [\"" + family("q") + "\"]\nmomenta = [\"" + family("p") +
           "\"]\nhamiltonian = \"sum(" + sum + ", " + element("p") + "^2/2 + " + element("q") +
           "^2/2)\"\n[initial]\n\"" + element("q") + "\" = \"" + start + "\"\n\"" + element("p") +
           "\" = 0\n[run]\nmethod = \"stormer-verlet\"\nstep = 0.5\nuntil = 500\n";
}

/// Returns the picture of a run whose other files are gone.
std::string picture_of(const std::string& scene, const std::vector<std::string>& more = {}) {
    const Directory directory;
    std::vector<std::string> words{"run", scene, "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = hvi_gen(words, directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(names_in(directory / "out") ==
          std::vector<std::string>{"picture.svg", "summary.txt", "trajectory.csv"});
    return contents(directory / "out/picture.svg");
}

/// The input of gnuplot, which is kept in place of a picture: its script, and the rows of its
/// table.
struct Drawn {
    std::string script;
    std::vector<std::vector<double>> rows;
};

Drawn drawn_by_gnuplot(const std::string& scene) {
    const Directory directory;
    write(directory / "scene.toml", scene);
    write(directory / "gnuplot", "#!/bin/sh\ncp -R . ../seen && echo \"$*\" > "
                                 "../script && echo '<svg></svg>'\n");
    std::filesystem::permissions(directory / "gnuplot", std::filesystem::perms::owner_all);
    const Outcome outcome =
        shell("PATH=\"$PWD:$PATH\" hvi-gen run scene.toml -o out", directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    Drawn drawn{contents(directory / "script"), {}};
    for (const std::string& name : names_in(directory / "seen")) {
        if (name == "trajectory.csv" || name == "summary.txt") { continue; }
        const auto lines = lines_of(contents(directory / ("seen/" + name)));
        for (std::size_t k = 1; k < lines.size(); ++k) drawn.rows.push_back(numbers_of(lines[k]));
    }
    return drawn;
}

}  // namespace

TEST_CASE("the picture of a chain is an image of its places over time") {
    use_cache();
    const std::string picture = picture_of("sine-gordon", {"--until", "20"});
    CHECK(count_of(picture, "<image") == 1);
    CHECK(contains(picture, "u[i] over t"));
    CHECK(contains(picture, "energy, less that at the start"));
    CHECK(contains(picture_of("toda-ring", {"--until", "20"}), "q[i] over t"));
    // Not of one row, nor where others are asked for.
    CHECK(count_of(picture_of("sine-gordon", {"--until", "0"}), "<image") == 0);
    const std::string columns = picture_of("sine-gordon", {"--until", "1", "--columns", "u[7..9]"});
    CHECK(count_of(columns, "<image") == 0);
    CHECK(contains(columns, "u[8]"));
}

TEST_CASE("an image of a long chain has some of its places, and some of the steps") {
    use_cache();
    const Drawn drawn = drawn_by_gnuplot(swinging("3..1003", "i", "i=3..1003", "i"));
    CHECK(contains(drawn.script, "with image"));
    // 1001 places of which every third is shown, and 1000 steps.
    REQUIRE(drawn.rows.size() == 335);
    for (std::size_t row = 0; row < drawn.rows.size(); ++row) {
        const double t = row < 334 ? 1.5 * static_cast<double>(row) : 500;
        REQUIRE(drawn.rows[row].size() == 335);
        CHECK(drawn.rows[row][0] == t);
        // A step of this size advances the phase by acos(1 - h^2/2).
        const double swing = std::cos(t / 0.5 * std::acos(1 - 0.125));
        for (std::size_t k = 1; k < 335; ++k) {
            const double place = 3 * static_cast<double>(k);
            REQUIRE(std::abs(drawn.rows[row][k] - place * swing) < 1e-9);
        }
    }
}

TEST_CASE("the picture of a sheet has it at the start and at the end") {
    use_cache();
    const std::string picture = picture_of("phi4-plane", {"--until", "5", "--param", "N=20"});
    CHECK(count_of(picture, "<image") == 2);
    CHECK(contains(picture, "u[i,j] at t = 0<"));
    CHECK(contains(picture, "u[i,j] at t = 5<"));
    CHECK(count_of(picture_of("phi4-plane", {"--until", "0"}), "<image") == 0);

    const Drawn drawn =
        drawn_by_gnuplot(swinging("1..250,0..450", "i,j", "i=1..250, j=0..450", "i + 1000*j"));
    REQUIRE(drawn.rows.size() == 2);
    CHECK(drawn.rows[1][0] == 500);
    REQUIRE(drawn.rows[0].size() == 1 + 125 * 151);
    std::size_t column = 0;
    for (int i = 1; i <= 250; i += 2) {
        for (int j = 0; j <= 450; j += 3) { REQUIRE(drawn.rows[0][++column] == i + 1000 * j); }
    }
}

TEST_CASE("the picture of many bodies has the tracks of the first ones") {
    use_cache();
    const std::string picture = picture_of("ring-of-bodies", {"--until", "2"});
    CHECK(contains(picture, "y[8] over x[8]"));
    CHECK_FALSE(contains(picture, "x[9]"));
    CHECK(count_of(picture, "<image") == 0);
}

TEST_CASE("the picture of a run shows positions over time, as far as they are no bar") {
    use_cache();
    // 160 swings of which 20 turn back 40 times, and the closed orbit of all.
    const std::string swinging_long = picture_of("pendulum");
    CHECK(contains(swinging_long, ">q over t, until t = "));
    CHECK(contains(swinging_long, ">p over q<"));
    const std::string swinging_once = picture_of("pendulum", {"--until", "10"});
    CHECK(contains(swinging_once, ">q over t<"));
    CHECK(contains(swinging_once, ">energy, less that at the start, in 10"));
    CHECK_FALSE(contains(swinging_once, "e-1"));
    // Springs whose stiff ones would fill the plane.
    CHECK(contains(picture_of("fpu"), ">d[1] over x[1], until t = "));
}
