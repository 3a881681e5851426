// Frequencies of columns of runs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

constexpr const char* two_oscillators = R"toml(
hamiltonian = "(px^2 + py^2)/2 + x^2/2 + y^2"
coordinates = ["x", "y"]
momenta = ["px", "py"]
initial = {x = 1, y = "1/2", px = 0, py = "1/3"}
invariants = {both = {value = "x + y + 3", approximate = true}}
run = {method = "gauss:8", step = "1/10", until = 1000}
)toml";

/// Frequency, amplitude, phase and uncertainty of each term of a column.
using TermsOfColumn = std::vector<std::vector<double>>;

struct FrequencyRun {
    Outcome outcome;
    std::vector<std::string> lines, table;

    [[nodiscard]] TermsOfColumn column(const std::string& name) const {
        TermsOfColumn result;
        for (const std::string& line : lines)
            if (line.rfind(name + ",", 0) == 0) {
                std::vector<double> numbers = numbers_of(line.substr(name.size() + 1));
                CHECK(numbers.front() == static_cast<double>(result.size()));
                numbers.erase(numbers.begin());
                result.push_back(numbers);
            }
        return result;
    }
};

FrequencyRun analysed(const std::string& scene, const std::string& words) {
    use_cache();
    const Directory directory;
    std::string name = scene;
    if (scene.find('\n') != std::string::npos) {
        write(directory / "scene.toml", scene);
        name = "scene.toml";
    }
    FrequencyRun result;
    result.outcome =
        shell("exec \"$hvi_gen\" run " + name + " -o out --only table,summary " + words,
              directory.path());
    CAPTURE(result.outcome.err);
    REQUIRE(result.outcome.status == 0);
    result.table = lines_of(contents(directory / "out/trajectory.csv"));
    if (std::filesystem::exists(directory / "out/frequencies.csv"))
        result.lines = lines_of(contents(directory / "out/frequencies.csv"));
    return result;
}

void check_term(const std::vector<double>& term, double frequency, double amplitude, double phase) {
    CHECK(std::abs(term.at(0) - frequency) < 1e-12);
    CHECK(std::abs(term.at(0) - frequency) <= term.at(3));
    CHECK(term.at(3) < 1e-11);
    CHECK(std::abs(term.at(1) - amplitude) < 1e-11);
    CHECK(std::abs(std::remainder(term.at(2) - phase, 2 * pi)) < 1e-9);
}

}  // namespace

TEST_CASE("two oscillators have their frequencies, amplitudes and phases") {
    const FrequencyRun run = analysed(two_oscillators, "--frequencies \"both, x, energy\"");
    REQUIRE_FALSE(run.lines.empty());
    CHECK(run.lines.front() == "column,number,frequency,amplitude,phase,uncertainty");
    const TermsOfColumn both = run.column("both");
    REQUIRE(both.size() >= 3);
    CHECK(both[0][0] == 0);
    CHECK(both[0][1] == Approx(3));
    // y = cos(w t)/2 + sin(w t)/(3 w), w = sqrt(2).
    const double w = std::sqrt(2.0), b = 1 / (3 * w);
    check_term(both[1], 1, 1, 0);
    check_term(both[2], w, std::hypot(0.5, b), -std::atan2(b, 0.5));
    check_term(run.column("x").at(1), 1, 1, 0);
    CHECK(run.column("energy").size() == 1);
    CHECK(run.outcome.out.find("\nfrequencies  both: 1 +- ") != std::string::npos);
    CHECK(run.outcome.out.find("\nfrequencies  energy: constant\n") != std::string::npos);
    // Nothing else of the run is another one.
    const FrequencyRun plain = analysed(two_oscillators, "");
    CHECK(plain.table == run.table);
    CHECK(plain.lines.empty());
}

TEST_CASE("the frequency is that of the steps") {
    // A step of Stormer-Verlet turns by 2 asin(h/2).
    const FrequencyRun run =
        analysed("hamiltonian = \"(p^2 + q^2)/2\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                 "initial = {q = 1, p = 0}\n",
                 "--frequencies q --method stormer-verlet --step=-1/5 --until=-600");
    check_term(run.column("q").at(1), 2 * std::asin(0.1) / 0.2, 1, 0);
}

TEST_CASE("a pendulum has the frequency of the arithmetic-geometric mean") {
    // From rest at the angle 2: agm(1, cos(1)) (Gauss). Its series has odd multiples alone.
    double a = 1, g = std::cos(1.0);
    for (int k = 0; k < 6; ++k) {
        const double mean = (a + g) / 2;
        g = std::sqrt(a * g);
        a = mean;
    }
    const FrequencyRun run =
        analysed("hamiltonian = \"p^2/2 - cos(q)\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                 "initial = {q = 2, p = 0}\n",
                 "--frequencies q --method gauss:6 --step 1/10 --until 1000 --every 100");
    const TermsOfColumn terms = run.column("q");
    REQUIRE(terms.size() > 3);
    CHECK(terms[0][1] < 1e-9);
    for (std::size_t k = 1; k <= 3; ++k) {
        const double number = 2 * static_cast<double>(k) - 1;
        CHECK(std::abs(terms[k][0] - number * a) < 1e-9);
        CHECK(std::abs(terms[k][0] - number * a) <= terms[k][3] + 1e-11);
    }
}

TEST_CASE("rows at given times are samples, also of scaled time") {
    const FrequencyRun run = analysed(
        "hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\ncoordinates = [\"x\", \"y\"]\n"
        "momenta = [\"px\", \"py\"]\ninitial = {x = \"1/2\", y = 0, px = 0, py = \"sqrt(3)\"}\n"
        "[time]\nscale = \"logarithmic\"\n",
        "--frequencies x --method gauss:6 --step 1/10 --times 10:400:4000");
    const TermsOfColumn terms = run.column("x");
    REQUIRE(terms.size() > 3);
    // The mean of x is -3 e/2, the frequency that of Kepler's third law.
    CHECK(terms[0][1] == Approx(0.75).epsilon(1e-6));
    CHECK(std::abs(terms[1][0] - 1) < 1e-9);
    CHECK(std::abs(terms[2][0] - 2) < 1e-9);
    CHECK(std::abs(std::remainder(terms[1][2], 2 * pi)) < 1e-6);
}

TEST_CASE("frequencies that cannot be had are refused") {
    use_cache();
    const auto refused = [](const std::string& line, const std::string& message) {
        const Directory directory;
        write(directory / "scene.toml", two_oscillators);
        write(directory / "scaled.toml",
              std::string(two_oscillators) + "[time]\nscale = \"1 + x^2\"\n");
        const Outcome outcome =
            shell("exec \"$hvi_gen\" run " + line + " -o out", directory.path());
        CAPTURE(line, outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find(message) != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(directory / "out"));
    };
    refused("scene.toml --frequencies \"x, z\"",
            "error: there is no column `z`\n  --frequencies: x, z\n                    ^\n");
    refused("scene.toml --frequencies x --until 6",
            "--frequencies takes 64 rows at least, and here are 61");
    refused("scene.toml --frequencies x --times 0:10:63",
            "--frequencies takes 64 rows at least, and here are 63");
    refused("scaled.toml --frequencies x", "steps of scaled time are not");
    refused("scene.toml --frequencies x --checkpoint file",
            "--frequencies takes all rows of one run: it does not go with");
}

TEST_CASE("a run that ends early says that it has too few rows") {
    const FrequencyRun run =
        analysed(std::string(two_oscillators) + "[events.turn]\nzero = \"x\"\nstop = 1\n",
                 "--frequencies x");
    CHECK(run.outcome.out.find("frequencies  x: not analysed") != std::string::npos);
    CHECK(run.lines.size() == 1);
}
