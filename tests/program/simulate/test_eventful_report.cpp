// `hvi-gen report` on scenes whose runs jump, or whose steps are of scaled time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::test;
using Json = nlohmann::json;

namespace {

constexpr const char* scaled_oscillator = R"toml(
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "(p^2 + q^2)/2"
[initial]
q = 1
p = 0
[time]
scale = "1 + q^2/2"
[run]
step = "1/10"
until = 5
)toml";

/// The ball falls for a time of 1, so that it is where it began, and at rest, at t = 4.
constexpr const char* falling_ball = R"toml(
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 + q"
[initial]
q = "1/2"
p = 0
[run]
step = "1/10"
until = 4
)toml";

constexpr const char* floor_of_ball = R"toml(
[events.floor]
zero = "q"
direction = "down"
set = {p = "-p"}
stop = 1
)toml";

Json report_of(const std::string& text, const std::vector<std::string>& words,
               const Directory& directory) {
    write(directory / "scene.toml", text);
    std::vector<std::string> all{"report", "scene.toml", "-o", "out"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome result = hvi_gen(all, directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    return Json::parse(contents(directory / "out/report.json"));
}

double error_at(const Json& report, std::size_t method, std::size_t point) {
    return report.at("scenes")[0].at("methods")[method].at("points")[point].at("error");
}

bool has_note(const Json& report, const std::string& words) {
    for (const Json& note : report.at("notes"))
        if (note.get<std::string>().find(words) != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("errors of steps in scaled time are those at a time") {
    use_cache();
    const Directory directory;
    const std::string exact = "[exact]\nq = \"cos(t)\"\np = \"-sin(t)\"\n";
    const std::vector<std::string> words{"--methods",        "gauss:2, gauss:4", "--steps",
                                         "1/10, 1/20, 1/33", "--only",           "json,work"};
    const Json of_exact = report_of(scaled_oscillator + exact, words, directory);
    CHECK(of_exact.at("scenes")[0].at("reference").at("kind") == "exact");
    // The orders are 4 and 8: the step is halved.
    CHECK(std::abs(std::log2(error_at(of_exact, 0, 0) / error_at(of_exact, 0, 1)) - 4) < 0.2);
    CHECK(std::abs(std::log2(error_at(of_exact, 1, 0) / error_at(of_exact, 1, 1)) - 8) < 0.5);
    const Json& points = of_exact.at("scenes")[0].at("methods")[0].at("points");
    CHECK(points[2].at("h") == 1.0 / 33);
    // Since t = 5 is s + sin(2 t)/8 and more, there are fewer steps than of time, and the last is
    // short.
    CHECK(points[0].at("steps") > 35);
    CHECK(points[0].at("steps") < 50);
    CHECK(has_note(of_exact, "steps of scene are of scaled time"));

    // The reference by gauss:10 is as good.
    const Json of_runs = report_of(scaled_oscillator, words, directory);
    const Json reference = of_runs.at("scenes")[0].at("reference");
    CHECK(reference.at("kind") == "gauss:10 in 53 bits");
    CHECK(reference.at("error") < 1e-13);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(error_at(of_runs, 0, i) - error_at(of_exact, 0, i)) < 1e-13);
}

TEST_CASE("errors of runs that jump") {
    use_cache();
    const Directory directory;
    const Json report = report_of(std::string(falling_ball) + floor_of_ball,
                                  {"--methods", "stormer-verlet, symplectic-euler", "--steps",
                                   "1/64, 1/128", "--only", "json,work"},
                                  directory);
    const Json reference = report.at("scenes")[0].at("reference");
    CHECK(reference.at("kind") == "gauss:10 in 53 bits");
    CHECK(reference.at("error") < 1e-13);
    const Json& first = report.at("scenes")[0].at("methods")[0].at("points")[0];
    CHECK(first.at("h") == 1.0 / 64);
    CHECK(first.at("steps") == 256);
    // Stormer-Verlet makes no error where the force is constant, nor in its shorter steps.
    CHECK(error_at(report, 0, 0) < 1e-13);
    CHECK(std::abs(std::log2(error_at(report, 1, 0) / error_at(report, 1, 1)) - 1) < 0.3);
    CHECK(has_note(report, "the event floor of scene jumps"));

    // Beside the end that it should have.
    const std::string exact = "[exact]\nq = \"1/2 - (t - 4)^2/2\"\np = \"4 - t\"\n";
    const Json beside =
        report_of(std::string(falling_ball) + floor_of_ball + exact,
                  {"--methods", "gauss:2", "--steps", "1/64", "--only", "json,work"}, directory);
    CHECK(error_at(beside, 0, 0) < 1e-13);
    // Without a floor it is 15/2 below the ground, at the speed of 4.
    const Json falling =
        report_of(falling_ball + exact,
                  {"--methods", "gauss:2", "--steps", "1/64", "--only", "json,work"}, directory);
    CHECK(std::abs(error_at(falling, 0, 0) - std::hypot(8, 4) / 0.5) < 1e-9);
}

// The kink is met at t = 1, where no step of 3/80 ends.
TEST_CASE("errors of runs whose steps end at kinks") {
    use_cache();
    const Directory directory;
    const std::string pointed = "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                "hamiltonian = \"p^2/2 + abs(q)\"\n"
                                "[initial]\nq = \"1/2\"\np = 0\n"
                                "[run]\nstep = \"3/80\"\nuntil = \"3/2\"\n"
                                "[exact]\nq = \"(t - 2)^2/2 - 1/2\"\np = \"t - 2\"\n";
    const std::vector<std::string> words{"--methods", "stormer-verlet", "--steps",
                                         "3/80",      "--only",         "json,work"};
    const Json ended = report_of(pointed + "[time]\nkinks = \"events\"\n", words, directory);
    CHECK(error_at(ended, 0, 0) < 1e-12);
    CHECK(has_note(ended, "steps of scene end at kinks of its H"));
    // Across kinks the order is lost.
    CHECK(error_at(report_of(pointed, words, directory), 0, 0) > 1e-5);
}

TEST_CASE("reports that are not built for jumps and scaled time") {
    const Directory directory;
    const auto refused = [&](const std::string& text, const std::string& words,
                             const std::string& message) {
        write(directory / "scene.toml", text);
        const Outcome result = shell("hvi-gen report scene.toml " + words, directory.path());
        INFO(result.err);
        CHECK(result.status == 2);
        CHECK(result.err.find(message) != std::string::npos);
        CHECK(directory.names() == std::vector<std::string>{"scene.toml"});
    };
    refused(std::string(falling_ball) + floor_of_ball, "--peers",
            "are not built for scaled time, jumps");
    refused(scaled_oscillator, "--peers", "are not built for scaled time, jumps");
    refused(R"toml(
coordinates = ["q[1..3]"]
momenta = ["p[1..3]"]
hamiltonian = "sum(i=1..3, p[i]^2/2 + q[i]^2/2)"
initial = {"q[i]" = 1, "p[i]" = 0}
run = {step = "1/10", until = 1}
[time]
scale = "1 + q[1]^2"
)toml",
            "--unroll no", "time where sums stay loops");
}

TEST_CASE("steps of a report in scaled time that lead away from its end") {
    const Directory directory;
    write(directory / "scene.toml", scaled_oscillator);
    const Outcome result =
        hvi_gen({"report", "scene.toml", "--steps", "-1/10", "-o", "out"}, directory.path());
    CHECK(result.status == 1);
    CHECK(result.err.find("lead away from the end") != std::string::npos);
}
