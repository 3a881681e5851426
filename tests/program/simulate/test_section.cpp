// Derivatives of the time and the state of an event that ends a run.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

std::string scene_with_end(const std::string& H, const std::string& start, const std::string& event,
                           const std::string& method) {
    return "hamiltonian = \"" + H + "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\ninitial = {" +
           start + "}\nrun = {method = \"" + method + "\", step = \"3/10\", until = 30}\n" +
           "[events.end]\nstop = 1\n" + event;
}

using Matrix = std::vector<std::vector<double>>;

/// The rows of section.csv, which are named so.
Matrix section_of(const SceneRun& run, const std::vector<std::string>& names) {
    INFO(run.outcome.err);
    REQUIRE(run.outcome.status == 0);
    REQUIRE(run.section.size() == names.size() + 1);
    std::string head = "of";
    Matrix rows;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string& line = run.section[k + 1];
        CHECK(line.substr(0, line.find(',')) == names[k]);
        if (k > 0) head += "," + names[k];
        rows.push_back(numbers_of(line.substr(line.find(',') + 1)));
    }
    CHECK(run.section.front() == head);
    return rows;
}

void check_rows(const Matrix& found, const Matrix& expected, double tolerance) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t row = 0; row < found.size(); ++row) {
        REQUIRE(found[row].size() == expected[row].size());
        for (std::size_t k = 0; k < found[row].size(); ++k) {
            CAPTURE(row, k, found[row][k], expected[row][k]);
            CHECK(std::abs(found[row][k] - expected[row][k]) < tolerance);
        }
    }
}

/// A star in a galaxy; the start is moved by parameters.
const std::string star_of_sections =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "parameters = {a = 0, b = 0, c = 0, d = 0}\n"
    "initial = {x = \"a\", y = \"1/10 + b\", px = \"1/2 + c\", py = \"d\"}\n"
    "run = {method = \"gauss:8\", step = \"1/10\", until = 40}\n";

}  // namespace

TEST_CASE("a fall ends as its closed form says, and so do its neighbours") {
    // q = 4 + 3 t - t^2 is 0 at t = 4, and t* = (p + sqrt(p^2 + 4 q))/2, p* = -sqrt(p^2 + 4 q).
    for (const std::string how : {"--tangent", "--tangent --interpret"}) {
        const SceneRun fall = run_scene(
            scene_with_end("p^2/2 + 2*q", "q = 4, p = 3", "zero = \"q\"\n", "stormer-verlet"), how);
        check_rows(section_of(fall, {"t", "q", "p"}), {{0.2, 0.8}, {0, 0}, {-0.4, -0.6}}, 1e-12);
        // The matrix of the flow stays that of the time of the event.
        check_rows(fall.tangent, {{1, 4}, {0, 1}}, 1e-12);
    }
}

TEST_CASE("the oscillator comes to its surface by its angle") {
    // (q, p) turns clockwise from (3/5, 4/5): dt* = (q dp - p dq)/r^2; at q = 0 there is p = -r.
    const SceneRun found = run_scene(
        scene_with_end("(p^2 + q^2)/2", "q = \"3/5\", p = \"4/5\"", "zero = \"q\"\n", "gauss:16"),
        "--tangent");
    check_rows(section_of(found, {"t", "q", "p"}), {{-0.8, 0.6}, {0, 0}, {-0.6, -0.8}}, 1e-12);
}

TEST_CASE("a surface and a force that depend on the time") {
    // q = q0 + p0 t + t^3 meets t^3 - t + 7 at t* = (7 - q0)/(p0 + 1), which is 3 from (1, 1).
    const SceneRun found = run_scene(
        scene_with_end("p^2/2 - 6*t*q", "q = 1, p = 1", "zero = \"q - t^3 + t - 7\"\n", "gauss:6"),
        "--tangent");
    const double q = -1.0 / 2, p = -3.0 / 2;
    check_rows(section_of(found, {"t", "q", "p"}),
               {{q, p}, {1 + 28 * q, 3 + 28 * p}, {18 * q, 1 + 18 * p}}, 1e-11);
    // No return map leads to a surface that moves.
    CHECK(found.outcome.out.find("return map") == std::string::npos);
}

TEST_CASE("derivatives at an event are those of runs from starts nearby") {
    const std::string event = "[events.plane]\nzero = \"x + y^2/3 + px/5\"\nstop = 3\n";
    const SceneRun found = run_scene(star_of_sections + event, "--tangent");
    const Matrix section = section_of(found, {"t", "x", "y", "px", "py"});
    for (std::size_t k = 0; k < 4; ++k) {
        const std::string name(1, static_cast<char>('a' + k));
        const auto end = [&](const std::string& value) {
            return run_scene(star_of_sections + event, "--param " + name + "=" + value).event(2);
        };
        const std::vector<double> after = end("1e-5"), before = end("-1e-5");
        for (std::size_t row = 0; row < 5; ++row) {
            CAPTURE(name, row);
            CHECK(std::abs((after[row] - before[row]) / 2e-5 - section[row][k]) < 3e-7);
        }
    }
}

TEST_CASE("the return map of a closed orbit has its multipliers") {
    // x swings, and y falls off a hill: in a period of x a direction there grows by exp(pi).
    const std::string hill = "hamiltonian = \"(px^2 + py^2)/2 + x^2/2 - y^2/8\"\n"
                             "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                             "initial = {x = 0, y = 0, px = 1, py = 0}\n"
                             "run = {method = \"gauss:8\", step = \"1/10\", until = 10}\n"
                             "[events.again]\nzero = \"x\"\ndirection = \"up\"\nstop = 1\n";
    const SceneRun found = run_scene(hill, "--tangent");
    const std::vector<double> said = found.said("return map");
    REQUIRE(said.size() == 3);
    CHECK(said[0] == Approx(std::exp(pi)).epsilon(1e-5));
    CHECK(said[1] == Approx(1).epsilon(1e-5));
    CHECK(said[2] == Approx(std::exp(-pi)).epsilon(1e-5));
}

TEST_CASE("where no derivative of an event is built, a run says so and why") {
    const auto says = [](const SceneRun& run, const std::string& what) {
        INFO(run.outcome.err + run.outcome.out);
        CHECK(run.outcome.status == 0);
        CHECK(run.section.empty());
        CHECK(run.tangent.size() == 2);
        return run.outcome.out.find(what) != std::string::npos;
    };
    // From -1 with the velocity 1 steps of 1/8 hit 0 just so, where q^3 has no slope.
    CHECK(says(
        run_scene(scene_with_end("p^2/2", "q = -1, p = 1", "zero = \"q^3\"\n", "stormer-verlet"),
                  "--tangent --step 1/8"),
        "the motion touches `end`"));
    const std::string event = "[events.end]\nzero = \"q\"\nstop = 1\n";
    CHECK(says(run_scene("lagrangian = \"v^2/2 - q\"\ncoordinates = [\"q\"]\nvelocities = "
                         "[\"v\"]\ninitial = {q = 1, v = 0}\nrun = {method = \"gauss:4\", step = "
                         "\"1/10\", until = 10}\n" +
                             event,
                         "--tangent"),
               "are not built for a Lagrangian"));
    CHECK(says(run_scene("hamiltonian = \"sum(i=1..N, p[i]^2/2 + q[i])\"\ncoordinates = "
                         "[\"q[1..N]\"]\nmomenta = [\"p[1..N]\"]\nparameters = {N = 1}\ninitial = "
                         "{\"q[i]\" = 1, \"p[i]\" = 0}\nrun = {method = \"gauss:4\", step = "
                         "\"1/10\", until = 10}\n[events.end]\nzero = \"q[1]\"\nstop = 1\n",
                         "--tangent --unroll no"),
               "where sums stay loops"));
    // A run that no event ends has none, and without --tangent there is none.
    const std::string fall =
        scene_with_end("p^2/2 + 2*q", "q = 4, p = 3", "zero = \"q\"\n", "gauss:2");
    CHECK(run_scene(fall, "--tangent --until 3").section.empty());
    CHECK(run_scene(fall).section.empty());
}
