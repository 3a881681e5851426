// The modified Hamiltonian along runs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// A line of the summary: its first number, the largest change and that at the end; for the shadow
/// the error of differences too.
std::vector<double> changes(const SceneRun& run, const std::string& name) {
    for (const std::string& line : lines_of(run.outcome.out)) {
        if (line.rfind(name + " ", 0) != 0) continue;
        std::string words = line.substr(name.size());
        for (char& c : words)
            if (c == ',' || c == ';') c = ' ';
        std::istringstream stream(words);
        std::vector<double> numbers;
        for (std::string word; stream >> word;)
            if (word.find_first_of("0123456789") != std::string::npos)
                numbers.push_back(std::stod(word));
        return numbers;
    }
    FAIL("no line " << name << " in\n" << run.outcome.out << run.outcome.err);
    return {};
}

std::string shadow_scene(const std::string& H, const std::string& more = "") {
    return "hamiltonian = \"" + H +
           "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
           "initial = {q = 1, p = \"1/2\"}\n"
           "run = {method = \"stormer-verlet\", step = \"1/10\", until = 200}\n" +
           more;
}

constexpr const char* two_degrees = R"toml(
hamiltonian = "(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3"
coordinates = ["x", "y"]
momenta = ["px", "py"]
initial = {x = 0, y = "1/10", px = "1/2", py = 0}
run = {method = "stormer-verlet", step = "1/10", until = 200}
)toml";

}  // namespace

TEST_CASE("the shadow of an oscillator is the Hamiltonian whose exact flow its steps are") {
    // A step of kick, drift and kick is (c, h; -h (1 - h^2/4), c) with c = 1 - h^2/2 = cos(a):
    // the flow of (a/h) (p^2/s + s q^2)/2 with s^2 = 1 - h^2/4.
    const auto expected = [](double h, double q, double p) {
        const double a = 2 * std::asin(h / 2), s = std::sqrt(1 - h * h / 4);
        return a / h * (p * p / s + s * q * q) / 2;
    };
    const SceneRun slow = run_scene(shadow_scene("(p^2 + q^2)/2"), "--shadow");
    CHECK(std::abs(changes(slow, "shadow")[0] - expected(0.1, 1, 0.5)) < 1e-14);
    CHECK(changes(slow, "shadow")[1] < 1e-14);
    CHECK(changes(slow, "energy")[1] > 1e-4);
    // Also where H is at some distance from it, and the other way in time; and with a constant.
    const SceneRun fast =
        run_scene(shadow_scene("(p^2 + q^2)/2 + 3"), "--shadow --step=-1/2 --until=-50");
    CHECK(std::abs(changes(fast, "shadow")[0] - 3 - expected(0.5, 1, 0.5)) < 1e-9);
    CHECK(std::abs(changes(fast, "shadow")[0] - 3 - expected(0.5, 1, 0.5)) <
          changes(fast, "shadow")[3]);
}

TEST_CASE("steps of symplectic Euler have a shadow of order h") {
    // (1 - h^2, h; -h, 1) or its mirror image: the flow of (a/h) (p^2 + q^2 +- h q p)/(2 sin(a)/h).
    const double h = 0.1, a = 2 * std::asin(h / 2);
    const SceneRun run =
        run_scene(shadow_scene("(p^2 + q^2)/2"), "--shadow --method symplectic-euler");
    const double found = changes(run, "shadow")[0] / (a / std::sin(a) / 2) - 1.25;
    CHECK(std::abs(std::abs(found) - h / 2) < 1e-12);
}

TEST_CASE("the shadow stays where the energy oscillates") {
    for (const std::string how : {"", "--interpret", "--compose suzuki:4 --step 1/5",
                                  "--method gauss:2 --step 1/5", "--method lobatto:3 --step 1/5",
                                  "--method midpoint", "--solver newton --method midpoint"}) {
        const SceneRun run = run_scene(two_degrees, "--shadow " + how);
        CAPTURE(how, run.outcome.out, run.outcome.err);
        CHECK(changes(run, "energy")[1] > 1e-7);
        CHECK(changes(run, "shadow")[1] < 1e-10);
        CHECK(changes(run, "shadow")[1] < changes(run, "energy")[1] / 10000);
    }
}

TEST_CASE("and so where H is not separable, or T not quadratic") {
    const auto check = [](const std::string& H, const std::string& how) {
        const SceneRun run =
            run_scene(shadow_scene(H, "parameters = {m = 2}\n"), "--shadow " + how);
        CAPTURE(H, run.outcome.out, run.outcome.err);
        CHECK(changes(run, "energy")[1] > 1e-8);
        CHECK(changes(run, "shadow")[1] < 1e-11);
    };
    check("(p^2 + q^2)*(1 + q^2)/8", "--method gauss:2");
    check("m*(sqrt(1 + p^2/m) + (q^2 - 1)/4)", "--step 1/20");
    check("cosh(p) + q^2/2", "--step 1/20");
    check("p^2/(2*m) - cos(q)", "--step 1/20");
}

TEST_CASE("the shadow drifts where steps are none of a smooth Hamiltonian") {
    const SceneRun kink = run_scene(shadow_scene("p^2/2 + abs(q)"), "--shadow");
    CHECK(changes(kink, "shadow")[1] > 1e-4);
    // Where steps are large for the motion the series in h tells nothing any more.
    const SceneRun coarse = run_scene(two_degrees, "--shadow --step 9/10 --until 2000");
    CHECK(changes(coarse, "shadow")[1] > 1e-6);
    CHECK(changes(run_scene(two_degrees, "--shadow --step 1/20"), "shadow")[1] < 1e-13);
}

TEST_CASE("differences say how far they may be off") {
    // An orbit of the eccentricity 0.6 by an exact method: all changes are those of differences.
    for (const std::string step : {"1/5", "1/10", "1/20", "1/40"}) {
        const SceneRun run = run_scene(R"toml(
hamiltonian = "(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)"
coordinates = ["x", "y"]
momenta = ["px", "py"]
initial = {x = "2/5", y = 0, px = 0, py = 2}
run = {method = "gauss:12", until = 60}
)toml",
                                       "--shadow --step " + step);
        CAPTURE(run.outcome.out);
        CHECK(changes(run, "shadow")[1] < 10 * changes(run, "shadow")[3]);
        CHECK(changes(run, "shadow")[1] > changes(run, "shadow")[3] / 30);
    }
}

TEST_CASE("a run of few steps has no shadow") {
    const SceneRun run = run_scene(two_degrees, "--shadow --until 1");
    CHECK(run.outcome.status == 0);
    CHECK(run.outcome.out.find("shadow       not measured: that takes ") != std::string::npos);
}

TEST_CASE("shadows that are not built are refused") {
    use_cache();
    const auto refused = [](const std::string& line, const std::string& message) {
        const Directory directory;
        write(directory / "floor.toml",
              shadow_scene(
                  "p^2/2 + q",
                  "[events.floor]\nzero = \"q\"\ndirection = \"down\"\nset = {p = \"-p\"}\n"));
        write(directory / "kink.toml",
              shadow_scene("p^2/2 + abs(q)", "[time]\nkinks = \"events\"\n"));
        write(directory / "scaled.toml",
              shadow_scene("p^2/2 + q^2/2", "[time]\nscale = \"1 + q^2\"\n"));
        const Outcome outcome =
            shell("exec \"$hvi_gen\" run " + line + " --shadow -o out", directory.path());
        CAPTURE(line, outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find(message) != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(directory / "out"));
    };
    refused("floor.toml", "--shadow is not built for events that jump");
    refused("kink.toml", "--shadow is not built for kinks that end steps");
    refused("scaled.toml --method gauss:2", "--shadow is not built for");
    refused("bead-on-hoop --method gauss:4", "--shadow is not built for a Lagrangian");
    refused("heavy-top --method gauss:4", "--shadow is not built for scenes with rotations");
    refused("pendulum --basis monomials:1 --nodes gauss:3 --step 1/10",
            "--shadow is not built for methods with more nodes than functions");
    refused("fpu-chain --unroll no --method gauss:4", "--shadow");
    refused("henon-heiles --method strang --split auto",
            "error: shadows and balances of the energy are not built for flows of parts of H\n"
            "  --method: strang\n"
            "            ^~~~~~\n"
            "help: take a method that is no splitting: gauss:2\n");
}
