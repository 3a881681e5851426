// `hvi-gen run` of scenes whose sums stay loops: where they begin, and what becomes of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/cli/program.hpp"
#include "tests/simulate/cache.hpp"
#include "tests/simulate/table.hpp"

using namespace hvi::test;

namespace {

using Numbers = std::vector<double>;

/// The rows of a run, each without its time.
std::vector<Numbers> rows_of(const std::string& scene, const std::string& columns,
                             const std::vector<std::string>& more, const Directory& directory) {
    std::vector<std::string> words{"run",    scene,   "--columns", columns,
                                   "--only", "table", "-o",        "out"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = hvi_gen(words, directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const auto lines = lines_of(contents(directory / "out/trajectory.csv"));
    std::vector<Numbers> rows;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        rows.push_back(numbers_of(lines[k]));
        rows.back().erase(rows.back().begin());
    }
    return rows;
}

/// Pairs of springs, of which q[1], ..., q[40] begin as it is said.
std::string springs(const std::string& parameters, const std::string& start) {
    return "coordinates = [\"q[1..N]\", \"r[1..N]\"]\nmomenta = [\"p[1..N]\", \"s[1..N]\"]\n"
           "hamiltonian = \"sum(i=1..N, p[i]^2/2 + s[i]^2/2 + (q[i] - r[i])^2/2)\"\n"
           "[parameters]\nN = 40\n" +
           parameters + "[initial]\n\"r[i]\" = 0\n\"p[i]\" = 0\n\"s[i]\" = 0\n" + start +
           "\n[run]\nmethod = \"stormer-verlet\"\nstep = 0.1\nuntil = 0\n";
}

/// `[1, 1, 0, 0, ...]`
std::string list(const Numbers& values) {
    std::string text;
    for (const double value : values) {
        text += (text.empty() ? "" : ", ") + std::to_string(static_cast<int>(value));
    }
    return "[" + text + "]";
}

}  // namespace

// What compilers make of constants is not always the same: g++ 12.2 for AVX-512 takes 1, 1, 0, 0
// for 1, 1, 1, 1 where it copies an array that it sees.
TEST_CASE("lists are what the scene says") {
    use_cache();
    const Directory directory;
    Numbers values;
    for (int k = 0; k < 40; ++k) values.push_back(k % 8 < 6 ? k / 8 : 0);
    write(directory / "list.toml", springs("m = " + list(values) + "\n", "\"q[i]\" = \"m[i]\""));
    write(directory / "start.toml", springs("", "q = " + list(values)));
    CHECK(rows_of("list.toml", "q", {}, directory) == std::vector<Numbers>{values});
    CHECK(rows_of("start.toml", "q", {}, directory) == std::vector<Numbers>{values});
}

TEST_CASE("starts may have short sums in them") {
    use_cache();
    const Directory directory;
    write(directory / "steps.toml",
          springs("", "\"q[i]\" = \"sqrt(sum(k=1..9, if(4*k < i, 1, 0)))\""));
    const auto rows = rows_of("steps.toml", "q", {}, directory);
    REQUIRE(rows.size() == 1);
    for (std::size_t i = 1; i <= 40; ++i) {
        CHECK(rows[0][i - 1] == std::sqrt(static_cast<double>((i - 1) / 4)));
    }
    write(directory / "long.toml", springs("", "\"q[i]\" = \"1 + sum(k=1..17, 1/(k + i))\""));
    const Outcome refused = hvi_gen({"run", "long.toml"}, directory.path());
    CHECK(refused.status == 2);
    CHECK(refused.err.find("error: a sum inside a function is built only for at most 16 terms") ==
          0);
    CHECK(refused.err.find("long.toml:10: 1 + sum(k=1..17, 1/(k + i))\n") != std::string::npos);
}
