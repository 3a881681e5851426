// Runs of counted sweeps: what their summaries say, and their derivative.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// A star in a galaxy; the start is moved by parameters.
const std::string galaxy_star =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "parameters = {a = 0, b = 0, c = 0, d = 0}\n"
    "initial = {x = \"a\", y = \"1/10 + b\", px = \"1/2 + c\", py = \"d\"}\n"
    "run = {method = \"gauss:2\", step = \"1/4\", until = 10}\n";

/// The slope of the line that fits values at 0, 1, ..., n best, by the normal equations.
double fitted_slope(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double sum_k = 0, sum_kk = 0, sum = 0, sum_k_value = 0, k = 0;
    for (const double value : values) {
        sum_k += k;
        sum_kk += k * k;
        sum += value;
        sum_k_value += k * value;
        ++k;
    }
    return (count * sum_k_value - sum_k * sum) / (count * sum_kk - sum_k * sum_k);
}

std::string line_of(const SceneRun& run, const std::string& name) {
    for (const std::string& line : lines_of(run.outcome.out))
        if (line.rfind(name + " ", 0) == 0)
            return line.substr(line.find_first_not_of(' ', name.size()));
    return "";
}

}  // namespace

TEST_CASE("a summary of counted sweeps says what they are, and what they drift a step") {
    const SceneRun run = run_words("kepler --sweeps 1 --step 1/10 --until 100");
    REQUIRE(run.outcome.status == 0);
    CHECK(line_of(run, "sweeps") ==
          "explicit: exactly 1 sweep; symplectic up to the last change alone");
    CHECK(
        line_of(run, "angular_momentum").find("conserved, but for the last change of each step") !=
        std::string::npos);
    std::vector<double> energies;
    for (const std::vector<double>& row : run.rows()) energies.push_back(row[5] + 0.5);
    REQUIRE(energies.size() == 1001);
    const double drift = fitted_slope(energies);
    CHECK(std::abs(drift) > 1e-9);
    REQUIRE(run.said("drift").size() == 1);
    CHECK(run.said("drift")[0] == Approx(drift).epsilon(0.006));
    const std::string text = line_of(run, "drift");
    CHECK(text.find(" of the energy a step, ") != std::string::npos);
    const double part = std::stod(text.substr(text.find("step, ") + 6));
    CHECK(part == Approx(2 * drift).epsilon(0.006));
    // Steps to round-off have neither line.
    const SceneRun whole = run_words("kepler --step 1/10 --until 100");
    CHECK(line_of(whole, "sweeps").empty());
    CHECK(line_of(whole, "drift").empty());
    CHECK(line_of(whole, "angular_momentum").find("but for") == std::string::npos);
}

TEST_CASE("the energy drifts by the power of h up to which check proves steps symplectic") {
    // Slopes of gauss:2 are extrapolated with errors of h^3. One sweep gains two powers where T is
    // quadratic: symplectic up to h^5, and a drift of h^6 a step.
    const auto drift = [](const std::string& step) {
        return run_scene(galaxy_star, "--sweeps 1 --until 200 --step " + step).said("drift").at(0);
    };
    CHECK(drift("1/16") / drift("1/32") == Approx(64).epsilon(0.08));
}

TEST_CASE("the iterations of a step are its sweeps") {
    // The first two of 40 steps make 16 sweeps more.
    const SceneRun run = run_scene(galaxy_star, "--sweeps 3");
    CHECK(run.said("iterations") == std::vector<double>{3 + 2 * 16 / 40.0});
}

TEST_CASE("the derivative of counted sweeps is that of exactly these") {
    const auto end = [](const std::string& words) {
        std::vector<double> last = run_scene(galaxy_star, "--sweeps 1 " + words).last();
        return std::vector<double>(last.begin() + 1, last.begin() + 5);
    };
    const SceneRun along = run_scene(galaxy_star, "--sweeps 1 --tangent");
    const SceneRun to_round_off = run_scene(galaxy_star, "--tangent");
    REQUIRE(along.tangent.size() == 4);
    double apart = 0;
    const std::vector<std::string> names{"a", "b", "c", "d"};
    for (std::size_t column = 0; column < 4; ++column) {
        const auto ahead = end("--param " + names[column] + "=1e-6"),
                   behind = end("--param " + names[column] + "=-1e-6");
        for (std::size_t row = 0; row < 4; ++row) {
            const double expected = (ahead[row] - behind[row]) / 2e-6;
            CAPTURE(row, column);
            CHECK(std::abs(along.tangent[row][column] - expected) < 1e-9);
            apart = std::max(apart, std::abs(to_round_off.tangent[row][column] - expected));
        }
    }
    CHECK(apart > 1e-5);
}

TEST_CASE("a study and a module of counted sweeps say what they are") {
    use_cache();
    const Directory directory;
    const Outcome study = hvi_gen({"ensemble", "pendulum", "--sweeps", "2", "--vary", "q=0:1:2",
                                   "--until", "1", "-o", "study"},
                                  directory.path());
    INFO(study.err);
    REQUIRE(study.status == 0);
    CHECK(study.out.find("sweeps       explicit: exactly 2 sweeps; symplectic up to the last "
                         "change alone\n") != std::string::npos);
    REQUIRE(hvi_gen({"module", "pendulum", "--sweeps", "2"}, directory.path()).status == 0);
    CHECK(contents(directory / "pendulum.h").find("of exactly 2 sweeps each: symplectic up to") !=
          std::string::npos);
}

TEST_CASE("counted sweeps are in the race for an accuracy, marked, but for an action") {
    use_cache();
    const Directory directory;
    const auto table = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"stepper",    "pendulum", "--until", "5",
                                       "--accuracy", "1e-4",     "-o",      "x.hpp"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome found = hvi_gen(words, directory.path());
        INFO(found.err);
        REQUIRE(found.status == 0);
        return found.err;
    };
    const std::string all = table({});
    for (const std::string name : {"gauss:4 (3 sweeps)", "gauss:8 (4 sweeps)"}) {
        const std::size_t row = all.find(name);
        REQUIRE(row != std::string::npos);
        CHECK(all.substr(row, all.find('\n', row) - row).find(" explicit ") != std::string::npos);
    }
    CHECK(table({"--action"}).find("sweeps)") == std::string::npos);
}

TEST_CASE("a report shows counted sweeps beside steps to round-off, and marks them") {
    use_cache();
    const Directory directory;
    const Outcome outcome = hvi_gen({"report", "kepler", "--methods", "stormer-verlet, gauss:4",
                                     "--steps", "1/10, 1/20", "--until", "10", "--sweeps", "2",
                                     "--only", "json,work", "--no-symmetries"},
                                    directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const auto report = nlohmann::json::parse(contents(directory / "report/report.json"));
    const auto& methods = report.at("scenes")[0].at("methods");
    REQUIRE(methods.size() == 3);
    const auto &whole = methods[1], &counted = methods[2];
    CHECK(whole.at("name") == "gauss:4");
    CHECK_FALSE(whole.contains("sweeps"));
    CHECK(counted.at("name") == "gauss:4 (2 sweeps)");
    CHECK(counted.at("sweeps") == 2);
    CHECK(counted.at("conserved").empty());
    const auto& points = counted.at("points");
    REQUIRE(points.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& point = points[k];
        // Two steps of sixteen sweeps more.
        const double steps = point.at("steps");
        CHECK(point.at("iterations") == Approx(2 + 32 / steps));
        CHECK(point.at("error") != whole.at("points")[k].at("error"));
        CHECK(std::abs(point.at("drift").get<double>()) * steps < 1e-3);
        CHECK(point.at("drift") != 0);
    }
    const std::string note = report.at("notes")[0];
    CHECK(note.rfind("gauss:4 (2 sweeps) on kepler is explicit, and symplectic up to the last "
                     "change alone; the energy drifts by ",
                     0) == 0);
}
