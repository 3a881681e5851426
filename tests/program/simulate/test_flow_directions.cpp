// Directions along steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// A star in a galaxy as a rotation and what disturbs it; the start is moved by parameters.
const std::string split_star =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "parameters = {a = 0, b = 0, c = 0, d = 0}\n"
    "initial = {x = \"a\", y = \"1/10 + b\", px = \"1/2 + c\", py = \"d\"}\n"
    "run = {method = \"strang\", step = \"1/4\", until = 10}\n";

}  // namespace

TEST_CASE("the tangent of a turning flow is its rotation") {
    const SceneRun run = run_scene("hamiltonian = \"2*q^2 + p^2/2\"\ncoordinates = "
                                   "[\"q\"]\nmomenta = [\"p\"]\ninitial = {q = 1, p = 0}\n"
                                   "run = {method = \"strang\", step = \"1/4\", until = 5}\n",
                                   "--split auto --tangent");
    REQUIRE(run.tangent.size() == 2);
    CHECK(run.tangent[0][0] == Approx(std::cos(10.0)).margin(1e-14));
    CHECK(run.tangent[0][1] == Approx(std::sin(10.0) / 2).margin(1e-14));
    CHECK(run.tangent[1][0] == Approx(-2 * std::sin(10.0)).margin(1e-14));
    CHECK(run.tangent[1][1] == Approx(std::cos(10.0)).margin(1e-14));
}

TEST_CASE("the tangent of a splitting is that of its steps") {
    const auto end = [](const std::string& words) {
        const std::vector<double> last = run_scene(split_star, "--split auto " + words).last();
        return std::vector<double>(last.begin() + 1, last.begin() + 5);
    };
    const SceneRun along = run_scene(split_star, "--split auto --tangent");
    REQUIRE(along.tangent.size() == 4);
    const std::vector<std::string> names{"a", "b", "c", "d"};
    for (std::size_t column = 0; column < 4; ++column) {
        const auto ahead = end("--param " + names[column] + "=1e-6"),
                   behind = end("--param " + names[column] + "=-1e-6");
        for (std::size_t row = 0; row < 4; ++row) {
            CAPTURE(row, column);
            CHECK(std::abs(along.tangent[row][column] - (ahead[row] - behind[row]) / 2e-6) < 1e-8);
        }
    }
}

TEST_CASE("the tangent of orbits is that of their places, for every eccentricity") {
    // NOTE: the third is a parabola, and the last one goes on for periods in a step.
    for (const std::string start : {"0.8", "1.2", "sqrt(199/100)", "1.7", "0.1", "1.05, far"}) {
        const std::string speed = start.substr(0, start.find(','));
        const std::string step = start.find(',') == std::string::npos ? "1/2" : "15";
        const auto run = [&](const std::string& words) {
            return run_scene("hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\n"
                             "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                             "parameters = {a = 0, b = 0, c = 0, d = 0}\n"
                             "initial = {x = \"1 + a\", y = \"b\", px = \"1/10 + c\", py = \"" +
                                 speed + " + d\"}\nrun = {method = \"strang\", step = \"" + step +
                                 "\", until = 30}\n",
                             "--split auto " + words);
        };
        const SceneRun along = run("--tangent");
        REQUIRE(along.tangent.size() == 4);
        const std::vector<std::string> names{"a", "b", "c", "d"};
        for (std::size_t column = 0; column < 4; ++column) {
            const auto end = [&](const std::string& by) {
                return run("--param " + names[column] + "=" + by).last();
            };
            // NOTE: differences of order 4.
            const std::vector<double> p = end("1e-4"), m = end("-1e-4"), pp = end("2e-4"),
                                      mm = end("-2e-4");
            for (std::size_t row = 0; row < 4; ++row) {
                CAPTURE(start, row, column);
                const std::size_t k = row + 1;
                const double expected = (8 * (p[k] - m[k]) - (pp[k] - mm[k])) / 12e-4;
                const double tolerance = 1e-5 * (1 + std::abs(expected));
                CHECK(std::abs(along.tangent[row][column] - expected) < tolerance);
            }
        }
    }
}

TEST_CASE("the tangent of planets is canonical") {
    const SceneRun run = run_words("outer-solar-system --split jacobi --method mclachlan:8.4 "
                                   "--step 200 --until 20000 --tangent");
    REQUIRE(run.tangent.size() == 36);
    CHECK(run.outcome.out.find("D^T J D - J is ") != std::string::npos);
    const std::string text = run.outcome.out.substr(run.outcome.out.find("D - J is ") + 9);
    CHECK(std::stod(text) < 1e-12);
}

TEST_CASE("Lyapunov exponents go along with flows") {
    const SceneRun flows = run_scene(split_star, "--split auto --lyapunov --until 100");
    const SceneRun kicks = run_scene(split_star, "--method gauss:8 --lyapunov --until 100");
    REQUIRE(flows.said("lyapunov").size() == 1);
    CHECK(flows.said("lyapunov")[0] == Approx(kicks.said("lyapunov").at(0)).margin(2e-3));
}
