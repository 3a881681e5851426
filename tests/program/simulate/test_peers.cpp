// `hvi-gen report --peers`: integrators of other libraries beside ours.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;

namespace {

struct Row {
    double h = 0, tolerance = 0, steps = 0, error = 0, seconds = 0, evaluations = 0;
};

using Curves = std::map<std::string, std::vector<Row>>;

/// NOTE: quoted cells have no comma here.
Curves curves_of(const std::string& csv) {
    Curves curves;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        if (line.front() == '#') continue;
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        const auto number = [&](std::size_t i) {
            return cells.at(i).empty() ? 0 : std::stod(cells.at(i));
        };
        curves[cells.at(1).substr(1, cells.at(1).size() - 2)].push_back(
            {number(4), number(5), number(6), number(7), number(9), number(11)});
    }
    return curves;
}

/// The table of a report on a scene, in steps of 1/32, 1/64 and 1/128 where they are equal.
std::string report(const std::vector<std::string>& words, const std::string& before = "") {
    use_cache();
    const Directory directory;
    std::string line = before + "hvi-gen report --peers --only csv,work -o out";
    for (const std::string& word : words) line += " '" + word + "'";
    const Outcome result = shell(line, directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    CHECK(result.out.empty());
    return contents(directory / "out/report.csv");
}

/// log2 of by how much halving the steps takes the error down, at the end of the curve.
double order_of(const std::vector<Row>& rows) {
    REQUIRE(rows.size() == 3);
    return std::log2(rows[1].error / rows[2].error);
}

bool has_note(const std::string& csv, const std::string& note) {
    return csv.find("\n# " + note) != std::string::npos;
}

}  // namespace

TEST_CASE("peers come to the end of Kepler's problem as well as their order and tolerance say") {
    const std::string csv =
        report({"kepler", "--until", "8", "--methods", "gauss:2", "--steps", "1/32, 1/64, 1/128"});
    const Curves curves = curves_of(csv);
    const std::vector<Row>& ours = curves.at("gauss:2");
    CHECK(std::abs(order_of(ours) - 4) < 0.2);

    if (has_note(csv, "odeint is ")) {
        for (const char* name : {"odeint:bulirsch-stoer", "odeint:rkf78"}) {
            INFO(name);
            const std::vector<Row>& rows = curves.at(name);
            REQUIRE(rows.size() == 8);
            CHECK(rows.front().tolerance == 1e-3);
            CHECK(rows.front().error > 1e-4);
            CHECK(rows.back().error < 1e-9);
            CHECK(rows.back().h < rows.front().h);
            CHECK(rows.back().seconds > 0);
        }
        CHECK(std::abs(order_of(curves.at("odeint:sb3a")) - 4) < 0.2);
    }
    if (has_note(csv, "gsl is ")) {
        CHECK(curves.at("gsl:rk8pd").back().error < 1e-9);
        // Gauss' method too, which takes each step as two halves.
        const std::vector<Row>& halved = curves.at("gsl:rk4imp");
        CHECK(std::abs(order_of(halved) - 4) < 0.2);
        for (std::size_t i = 0; i + 1 < ours.size(); ++i) {
            CHECK(halved[i].h == 2 * ours[i + 1].h);
            CHECK(std::abs(halved[i].error / ours[i + 1].error - 1) < 0.01);
        }
    }
    CHECK((has_note(csv, "odeint is ") ||
           has_note(csv, "Boost.Odeint is not installed, and left out")));
    CHECK((has_note(csv, "gsl is ") ||
           has_note(csv, "the GNU Scientific Library is not installed, and left out")));
}

TEST_CASE("peers are in the pictures over time too") {
    use_cache();
    const Directory directory;
    const Outcome result = hvi_gen({"report", "kepler", "--peers", "--until", "8", "--methods",
                                    "gauss:2", "--steps", "1/32, 1/64", "--only", "svg,csv,work"},
                                   directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const std::string csv = contents(directory / "report/report.csv");
    for (const char* name : {"kepler-3-energy.svg", "kepler-4-invariants.svg"}) {
        const std::string svg = contents(directory / "report" / name);
        CHECK(svg.find("gauss:2, h = ") != std::string::npos);
        for (const std::string peer : {"odeint:rkf78", "odeint:sb3a", "gsl:rk4imp"}) {
            const std::string library = peer.substr(0, peer.find(':'));
            // NOTE: SB3A keeps the angular momentum to the last bit or so.
            CHECK((svg.find(peer + ", h = ") != std::string::npos) ==
                  has_note(csv, library + " is "));
        }
    }
}

TEST_CASE("peers take a quadratic H that is not separable, with explicit time") {
    // In s = sin(t) it is dz/ds = A z with A^2 = -0.64.
    use_cache();
    const Directory directory;
    write(directory / "driven.toml", "name = \"driven\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                     "hamiltonian = \"cos(t)*(5*p^2 + 6*p*q + 5*q^2)/10\"\n"
                                     "[initial]\nq = 1\np = 0\n"
                                     "[exact]\nq = \"cos(4/5*sin(t)) + 3/4*sin(4/5*sin(t))\"\n"
                                     "p = \"-5/4*sin(4/5*sin(t))\"\n"
                                     "[run]\nmethod = \"gauss:2\"\nstep = \"1/16\"\nuntil = 2\n");
    const std::string csv = report({(directory / "driven.toml").string(), "--methods", "gauss:2",
                                    "--steps", "1/8, 1/16, 1/32"});
    const Curves curves = curves_of(csv);
    CHECK(curves.count("odeint:sb3a") == 0);
    if (has_note(csv, "odeint is ")) CHECK(curves.at("odeint:rkf78").back().error < 1e-12);
    if (has_note(csv, "gsl is ")) {
        CHECK(curves.at("gsl:rk8pd").back().error < 1e-12);
        const double ratio = curves.at("gsl:rk4imp")[0].error / curves.at("gauss:2")[1].error;
        CHECK(std::abs(ratio - 1) < 0.01);
    }
}

TEST_CASE("a library that is not installed is left out, and the report says so") {
    use_cache();
    const Directory directory;
    write(directory / "cxx", "#!/bin/sh\ngrep -q boost main.cpp 2> /dev/null && exit 1\nexec " +
                                 compiler_of_tests() + " \"$@\"\n");
    std::filesystem::permissions(directory / "cxx", std::filesystem::perms::owner_all);
    write(directory / "skew.toml",
          "name = \"skew\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
          "hamiltonian = \"(5*p^2 + 6*p*q + 5*q^2)/10\"\n[initial]\nq = 1\np = 0\n"
          "[exact]\nq = \"cos(4/5*t) + 3/4*sin(4/5*t)\"\np = \"-5/4*sin(4/5*t)\"\n"
          "[run]\nmethod = \"gauss:2\"\nstep = \"1/16\"\nuntil = 2\n");
    const std::string csv = report({"harmonic-oscillator", (directory / "skew.toml").string(),
                                    "--until", "2", "--methods", "gauss:2", "--steps", "1/4"},
                                   "CXX='" + (directory / "cxx").string() + "' ");
    CHECK(has_note(csv, "Boost.Odeint is not installed, and left out"));
    const Curves curves = curves_of(csv);
    CHECK(curves.count("odeint:rkf78") == 0);
    CHECK(curves.count("gsl:rk8pd") == (has_note(csv, "gsl is ") ? 1 : 0));
    if (!has_note(csv, "gsl is ")) return;
    // Where H is quadratic Newton's method is at the end after one iteration, if its second
    // derivatives are right, and sees it no later than in the next: at most three times two of
    // them at two stages, and the slopes there.
    const std::vector<Row>& rows = curves.at("gsl:rk4imp");
    REQUIRE(rows.size() == 2);
    for (const Row& row : rows) CHECK(row.evaluations <= 18 * row.steps);
}
