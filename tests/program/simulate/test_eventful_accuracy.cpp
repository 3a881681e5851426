// Methods and steps for an accuracy, of runs in scaled time, with jumps, and from kink to kink.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// Unit oscillator from q = 1 at rest.
std::string swing_until(const std::string& end) {
    return "hamiltonian = \"(p^2 + q^2)/2\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
           "initial = {q = 1, p = 0}\nrun = {step = \"1/10\", until = " +
           end + "}\n";
}
const std::string swing_of_one = swing_until("5");

const std::string swing_in_scaled_time = swing_of_one + "[time]\nscale = \"(1 + q^2)/50\"\n";

/// An ellipse with the semi-axis 1 from its perihelion, for three revolutions.
const std::string comet = "hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\n"
                          "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                          "initial = {x = \"1/10\", y = 0, px = 0, py = \"sqrt(19)\"}\n"
                          "run = {step = \"1/10\", until = \"6*pi\"}\n"
                          "[time]\nscale = \"logarithmic\"\n";

bool is_said_in(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The distance of the last row from a state, relative to its size.
double error_at_end(const SceneRun& run, const std::vector<double>& expected) {
    const std::vector<double> last = run.last();
    REQUIRE(last.size() > expected.size());
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        sum += std::pow(last[1 + k] - expected[k], 2);
        size += std::pow(expected[k], 2);
    }
    return std::sqrt(sum / size);
}

/// Checks that a run comes to its end with an error of at most that.
SceneRun check_run(const std::string& scene, const std::string& accuracy,
                   const std::vector<double>& expected) {
    SceneRun run = run_scene(scene, "--accuracy " + accuracy + " --budget 20");
    INFO(run.outcome.err);
    REQUIRE(run.outcome.status == 0);
    CHECK(error_at_end(run, expected) <= 1.02 * std::stod(accuracy));
    return run;
}

}  // namespace

TEST_CASE("run --accuracy in scaled time comes to its end with the error that was asked for") {
    const SceneRun run = check_run(swing_in_scaled_time, "1e-6", {std::cos(5), -std::sin(5)});
    CHECK(is_said_in(run.outcome.err,
                     "errors of at most 1e-06 on scene at t = 5, beside gauss:10 in "));
    CHECK(is_said_in(run.outcome.out, " in scaled time, until t = 5\n"));
    // K = g (H + e) is not separable.
    CHECK_FALSE(is_said_in(run.outcome.err, "stormer-verlet"));
    check_run(swing_in_scaled_time + "[exact]\nq = \"cos(t)\"\np = \"-sin(t)\"\n", "1e-4",
              {std::cos(5), -std::sin(5)});
}

TEST_CASE("explicit methods take part where the scaled H is separable") {
    const SceneRun run = check_run(comet, "1e-7", {0.1, 0, 0, std::sqrt(19.0)});
    CHECK(is_said_in(run.outcome.err, "  stormer-verlet-kahan-li:8 "));
    CHECK(is_said_in(run.outcome.err, "  gauss:8 "));
}

TEST_CASE("stepper --accuracy in scaled time says steps that a run takes as they are") {
    use_cache();
    const Directory directory;
    write(directory / "scene.toml", comet);
    const Outcome stepper =
        hvi_gen({"stepper", "scene.toml", "--accuracy", "1e-5", "--budget", "20", "-o", "x.hpp"},
                directory.path());
    INFO(stepper.err);
    REQUIRE(stepper.status == 0);
    const std::string header = contents(directory / "x.hpp");
    const std::string before = "steps of ", after = " in scaled time, with an error of ";
    const std::size_t begin = header.find(before), end = header.find(after);
    REQUIRE(begin != std::string::npos);
    REQUIRE(end != std::string::npos);
    const std::string step = header.substr(begin + before.size(), end - begin - before.size());
    const std::size_t command = header.find("hvi-gen stepper");
    std::string words = header.substr(command, header.find('\n', command) - command);
    words.replace(0, std::string("hvi-gen stepper").size(), "");
    const std::string scene = "scene.toml";
    words.erase(words.find(scene), scene.size());
    const SceneRun run = run_words_in(directory, scene + words + " --step " + step);
    INFO(words << run.outcome.err);
    REQUIRE(run.outcome.status == 0);
    const double promised = std::stod(header.substr(end + after.size()));
    CHECK(error_at_end(run, {0.1, 0, 0, std::sqrt(19.0)}) == Approx(promised).epsilon(0.02));
}

TEST_CASE("run --accuracy goes through jumps and from kink to kink") {
    // A wall at 0 throws the oscillator back: q = |cos(t)|. NOTE: once, as steps that look over two
    // throws end where these lead, too.
    const std::string wall = swing_until("3") +
                             "[events.wall]\nzero = \"q\"\ndirection = \"down\"\n"
                             "set = {p = \"-p\"}\n";
    const SceneRun run = check_run(wall, "1e-6", {-std::cos(3), std::sin(3)});
    CHECK(run.events.size() == 2);  // with the names
    check_run(swing_of_one + "[events.wall]\nzero = \"q\"\ndirection = \"down\"\n"
                             "set = {p = \"-p/2\"}\n",
              "1e-6", {std::cos(5) / 4, -std::sin(5) / 4});
    // The solution of q'' = -q - sign(q) from q = 3 is 4 cos(t) - 1 until cos(t) = 1/4, and then
    // 1 + a cos(t) + b sin(t).
    const double t = std::acos(0.25), p = -4 * std::sin(t), left = 2.5 - t;
    check_run("hamiltonian = \"(p^2 + q^2)/2 + abs(q)\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
              "initial = {q = 3, p = 0}\nrun = {step = \"1/10\", until = \"5/2\"}\n"
              "[time]\nkinks = \"events\"\n",
              "1e-6",
              {1 - std::cos(left) + p * std::sin(left), std::sin(left) + p * std::cos(left)});
}

TEST_CASE("accuracies of runs with events and scaled time that cannot be") {
    use_cache();
    const auto refused = [](const std::string& scene, const std::string& words, int status,
                            const std::string& what) {
        const SceneRun run = run_scene(scene, words);
        CAPTURE(words, run.outcome.err);
        CHECK(run.outcome.status == status);
        CHECK(is_said_in(run.outcome.err, what));
        CHECK(run.table.empty());
    };
    const std::string springs =
        "hamiltonian = \"sum(i=1..N, p[i]^2/2 + q[i]^2/2)\"\ncoordinates = [\"q[1..N]\"]\n"
        "momenta = [\"p[1..N]\"]\nparameters = {N = 3}\ninitial = {\"q[i]\" = 1, \"p[i]\" = 0}\n"
        "run = {step = \"1/10\", until = 1}\n";
    const std::string loops = "--accuracy is not built for jumps, kinks that end steps and scaled "
                              "time where sums stay loops";
    refused(springs + "[time]\nscale = \"1 + q[1]^2\"\n", "--accuracy 1e-3 --unroll no", 2, loops);
    refused(springs + "[events.wall]\nzero = \"q[1]\"\nset = {\"p[1]\" = \"-p[1]\"}\n",
            "--accuracy 1e-3 --unroll no", 2, loops);
    // Rounding is in the way.
    refused(swing_in_scaled_time, "--accuracy 1e-16 --budget 4", 1, "is known with an error of");
    // At q = 2 the time stops, and 3 is never reached.
    refused("hamiltonian = \"p^2/2\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
            "initial = {q = 0, p = 1}\nrun = {step = \"1/10\", until = 3}\n"
            "[time]\nscale = \"(2 - q)^3\"\n",
            "--accuracy 1e-3 --budget 2", 1, "gauss:10 does not come to the end");
    refused(swing_in_scaled_time, "--accuracy 1e-3 --until=-1", 1, "lead away from the end");
}
