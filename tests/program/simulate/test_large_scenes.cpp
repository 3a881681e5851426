// `hvi-gen run` of scenes whose sums stay loops: where they begin, and what becomes of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"
#include "tests/program/simulate/table.hpp"

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

/// Pairs of springs; q[1], ..., q[40] begin at `start`.
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

/// All x, then all y and all z.
struct Atoms {
    Numbers positions;

    [[nodiscard]] std::size_t count() const { return positions.size() / 3; }

    /// Calls see(i, j, square of the distance, its three parts) for each pair.
    template <class See>
    void for_each_pair(See see) const {
        const std::size_t n = count();
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                std::array<double, 3> d{};
                for (std::size_t k = 0; k < 3; ++k) {
                    d[k] = positions[k * n + i] - positions[k * n + j];
                }
                see(i, j, d[0] * d[0] + d[1] * d[1] + d[2] * d[2], d);
            }
        }
    }

    [[nodiscard]] double energy() const {
        double sum = 0;
        for_each_pair([&](std::size_t, std::size_t, double s, const auto&) {
            sum += 4 * (std::pow(s, -6) - std::pow(s, -3));
        });
        return sum;
    }

    [[nodiscard]] Numbers gradient() const {
        const std::size_t n = count();
        Numbers result(3 * n);
        for_each_pair([&](std::size_t i, std::size_t j, double s, const auto& d) {
            const double slope = 8 * (3 * std::pow(s, -4) - 6 * std::pow(s, -7));
            for (std::size_t k = 0; k < 3; ++k) {
                result[k * n + i] += slope * d[k];
                result[k * n + j] -= slope * d[k];
            }
        });
        return result;
    }

    /// Down to the next minimum: steepest descent with the steps of Barzilai & Borwein.
    void relax() {
        double step = 1e-3;
        Numbers slope = gradient();
        for (int round = 0; round < 100; ++round) {
            double moved = 0, along = 0;
            for (std::size_t k = 0; k < slope.size(); ++k) positions[k] -= step * slope[k];
            const Numbers next = gradient();
            for (std::size_t k = 0; k < slope.size(); ++k) {
                moved += step * slope[k] * step * slope[k];
                along += step * slope[k] * (slope[k] - next[k]);
            }
            slope = next;
            if (moved < 1e-24) { return; }
            step = moved / along;
        }
        FAIL("it does not come to rest");
    }
};

double sum_of(const Numbers& row, std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t k = begin; k < end; ++k) sum += row[k];
    return sum;
}

}  // namespace

// NOTE: compilers may treat constants wrongly: g++ 12.2 for AVX-512 takes 1, 1, 0, 0 for 1, 1, 1, 1
// where it copies an array that it sees.
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
    const Outcome refused = hvi_gen({"run", "long.toml", "--unroll", "no"}, directory.path());
    CHECK(refused.status == 2);
    CHECK(refused.err.find("error: a sum inside a function is built only for at most 16 terms") ==
          0);
    CHECK(refused.err.find("long.toml:10: 1 + sum(k=1..17, 1/(k + i))\n") != std::string::npos);
}

TEST_CASE("38 atoms are those of the lowest energy that is known") {
    use_cache();
    const Directory directory;
    const auto rows = rows_of("lennard-jones-38", "x, y, z, energy", {"--until", "0"}, directory);
    REQUIRE(rows.size() == 1);
    REQUIRE(rows[0].size() == 115);
    Atoms atoms{{rows[0].begin(), rows[0].end() - 1}};
    CHECK(std::abs(atoms.energy() + 173.8132147708503) < 1e-10);  // of 6 + 8 + 24 whole numbers
    atoms.relax();
    CHECK(std::abs(atoms.energy() + 173.928427) < 1e-6);  // Doye, Miller & Wales, Table I
}

TEST_CASE("a thousand atoms begin as a ball in which none is too near to another") {
    use_cache();
    const Directory directory;
    const auto rows =
        rows_of("droplet", "x, y, z, px, py, pz, energy", {"--until", "0"}, directory);
    REQUIRE(rows.size() == 1);
    const Numbers& row = rows[0];
    REQUIRE(row.size() == 6001);
    const Atoms atoms{{row.begin(), row.begin() + 3000}};
    double nearest = 1e9, potential = 0;
    // Slope and curvature by the square of the distance, at the cut-off.
    const double cut = 6.25, value = 4 * (std::pow(cut, -6) - std::pow(cut, -3)),
                 slope = 12 * (std::pow(cut, -4) - 2 * std::pow(cut, -7)),
                 curvature = 24 * (7 * std::pow(cut, -8) - 2 * std::pow(cut, -5));
    atoms.for_each_pair([&](std::size_t, std::size_t, double s, const auto&) {
        nearest = std::min(nearest, std::sqrt(s));
        if (s < cut) {
            potential += 4 * (std::pow(s, -6) - std::pow(s, -3)) - value - slope * (s - cut) -
                         curvature / 2 * (s - cut) * (s - cut);
        }
    });
    double kinetic = 0, farthest = 0;
    for (std::size_t k = 3000; k < 6000; ++k) kinetic += row[k] * row[k] / 2;
    for (std::size_t i = 0; i < 1000; ++i) {
        farthest = std::max(farthest, std::hypot(row[i], row[1000 + i], row[2000 + i]));
    }
    CHECK(nearest > 0.95);
    CHECK(farthest < 1.03 * std::cbrt(3000 / (4 * std::acos(-1.0) * 0.8)));
    CHECK(std::abs(kinetic / 1000 - 0.9) < 1e-3);  // 3/2 of the temperature
    CHECK(std::abs(row[6000] - kinetic - potential) < 1e-9 * std::abs(potential));
    for (std::size_t k = 3000; k < 6000; k += 1000) {
        CHECK(std::abs(sum_of(row, k, k + 1000)) < 1e-13);
    }
}

TEST_CASE("a breather stays where it is, in the plane too") {
    use_cache();
    const Directory directory;
    const auto rows = rows_of("sine-gordon-plane", "u[64,64], u[64,1], energy",
                              {"--until", "100", "--param", "N=128"}, directory);
    REQUIRE(rows.size() == 1001);
    double middle = 0, edge = 0, lost = 0;
    for (std::size_t k = 500; k < rows.size(); ++k) {
        middle = std::max(middle, std::abs(rows[k][0]));
        edge = std::max(edge, std::abs(rows[k][1]));
        lost = std::max(lost, std::abs(rows[k][2] / rows[0][2] - 1));
    }
    CHECK(middle > 3.5);
    CHECK(edge < 0.5);
    CHECK(lost < 3e-3);
}
