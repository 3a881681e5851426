// Least, largest and mean values of columns over a run.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// The text of the summary behind a name.
double said_in(const std::string& summary, const std::string& name) {
    SceneRun run;
    run.outcome.out = summary;
    const std::vector<double> numbers = run.said(name);
    CAPTURE(name, summary);
    REQUIRE(numbers.size() == 1);
    return numbers.front();
}

/// A column behind the times, and these.
struct ColumnOverTime {
    std::vector<double> times, values;

    [[nodiscard]] double mean() const {
        double sum = 0;
        for (std::size_t k = 1; k < times.size(); ++k)
            sum += (times[k] - times[k - 1]) * (values[k] + values[k - 1]) / 2;
        return sum / (times.back() - times.front());
    }
};

Approx nearly(double value) { return Approx(value).epsilon(1e-9).margin(1e-12); }

/// Checks that a run with few rows has the reductions of a table with a row for each step.
void reduces_as_table(const std::string& words, const std::string& few, const std::string& column) {
    CAPTURE(words, column);
    use_cache();
    const Directory directory;
    const auto run = [&](const std::string& more) {
        const Outcome outcome =
            shell("exec \"$hvi_gen\" run " + words + " --only table,summary --columns \"" + column +
                      "\" " + more,
                  directory.path());
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return outcome.out;
    };
    run("--every 1 -o all");
    run(few + " -o few");
    const std::string said = run(few + " -o reduced --reduce \"min(" + column + "), max(" + column +
                                 "), mean(" + column + ")\"");
    CHECK(contents(directory / "reduced/trajectory.csv") ==
          contents(directory / "few/trajectory.csv"));
    ColumnOverTime all;
    const auto lines = lines_of(contents(directory / "all/trajectory.csv"));
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const std::vector<double> row = numbers_of(lines[k]);
        all.times.push_back(row.at(0));
        all.values.push_back(row.at(1));
    }
    REQUIRE(all.times.size() > 20);
    const auto [least, largest] = std::minmax_element(all.values.begin(), all.values.end());
    CHECK(said_in(said, "min(" + column + ")") == nearly(*least));
    CHECK(said_in(said, "max(" + column + ")") == nearly(*largest));
    CHECK(said_in(said, "mean(" + column + ")") == nearly(all.mean()));
}

}  // namespace

TEST_CASE("over an orbit of Kepler's problem reductions are those of the ellipse") {
    // NOTE: with the half axis 1 and the eccentricity e, x runs from 1 - e to -1 - e, and its mean
    // over time is -3 e/2. Of a periodic function the trapezoidal rule has the mean to round-off.
    use_cache();
    const Outcome outcome = shell("exec \"$hvi_gen\" run kepler --method gauss:8 --step pi/500 "
                                  "--until 2*pi --only summary --reduce "
                                  "\"min(x), max(x), mean(x), mean(y), max(energy)\"");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(said_in(outcome.out, "min(x)") == nearly(-1.6));
    CHECK(said_in(outcome.out, "max(x)") == nearly(0.4));
    CHECK(said_in(outcome.out, "mean(x)") == nearly(-0.9));
    CHECK(said_in(outcome.out, "mean(y)") == nearly(0));
    CHECK(said_in(outcome.out, "max(energy)") == nearly(-0.5));
}

TEST_CASE("reductions look at each step, whatever rows there are") {
    const std::string kepler = "kepler --method stormer-verlet --until 20 ";
    reduces_as_table(kepler, "--every 50", "x");
    reduces_as_table(kepler + "--interpret", "--every 50", "energy");
    reduces_as_table("kepler --method gauss:4 --step=-1/20 --until=-20 --interpret", "--every 7",
                     "py");
    reduces_as_table("fpu-chain --param N=200 --method stormer-verlet --step 1/10 --until 5",
                     "--every 20", "energy");
    reduces_as_table("fpu-chain --param N=200 --method stormer-verlet --step 1/10 --until 5",
                     "--every 20", "q[7]");
}

TEST_CASE("reductions of scaled time and of runs that an event ends within a step") {
    use_cache();
    const Directory directory;
    const std::string scene =
        "hamiltonian = \"(px^2 + py^2)/2 - 1/sqrt(x^2 + y^2)\"\ncoordinates = [\"x\", \"y\"]\n"
        "momenta = [\"px\", \"py\"]\ninitial = {x = \"1/10\", y = 0, px = 0, py = \"sqrt(19)\"}\n"
        "run = {method = \"stormer-verlet\", step = \"1/20\", until = 10}\n";
    write(directory / "scaled.toml", scene + "[time]\nscale = \"logarithmic\"\n");
    write(directory / "ended.toml", scene + "[events.axis]\nzero = \"y\"\ndirection = \"down\"\n"
                                            "stop = true\n");
    const std::string path = directory.path().string() + "/";
    reduces_as_table(path + "scaled.toml", "--every 9", "x");
    reduces_as_table(path + "scaled.toml --interpret", "--every 9", "energy");
    reduces_as_table(path + "ended.toml --step 1/100", "--every 30", "x");
    reduces_as_table(path + "ended.toml --step 1/100", "--every 30", "energy");
}

TEST_CASE("the last row of a run that an event ends has what is conserved there") {
    // NOTE: with so large a step Stormer-Verlet's energy changes a lot from step to step.
    const SceneRun run =
        run_scene("hamiltonian = \"p^2/2 - cos(q)\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                  "initial = {q = 0, p = \"3/2\"}\n"
                  "run = {method = \"stormer-verlet\", step = \"1/2\", until = 10}\n"
                  "[events.top]\nzero = \"p\"\nstop = true\n");
    INFO(run.outcome.err);
    REQUIRE(run.outcome.status == 0);
    const std::vector<double> last = run.last();
    REQUIRE(last.size() == 4);
    CHECK(std::fmod(last[0], 0.5) > 0.01);
    CHECK(last[3] == Approx(last[2] * last[2] / 2 - std::cos(last[1])).epsilon(1e-14));
}

TEST_CASE("a run that goes on has the reductions of the unbroken one, and others are refused") {
    use_cache();
    const Directory directory;
    const auto run = [&](const std::string& more) {
        return shell("exec \"$hvi_gen\" run kepler --method stormer-verlet --interpret --step 1/10 "
                     "--every 3 --only table,summary " +
                         more,
                     directory.path());
    };
    const std::string reduce = "--reduce \"min(x), max(energy), mean(y), mean(px)\" ";
    const auto made = [&](const std::string& more) {
        const Outcome outcome = run(reduce + more);
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        std::string without_clock;
        for (const std::string& line : lines_of(outcome.out))
            if (line.rfind("time ", 0) != 0) without_clock += line + "\n";
        return without_clock;
    };
    const std::string kept = "--checkpoint-every 50 --checkpoint ";
    const std::string whole = made("--until 20 -o whole " + kept + "whole.hvi");
    static_cast<void>(made("--until 11 -o parts " + kept + "parts.hvi"));
    CHECK(made("--until 20 -o parts --resume parts.hvi " + kept + "parts.hvi") == whole);
    CHECK(contents(directory / "whole.hvi").find("\nreductions 14 0 ") != std::string::npos);
    for (const std::string other : {"", "--reduce \"min(x)\" "}) {
        const Outcome refused = run(other + "--until 20 -o parts --resume parts.hvi");
        CHECK(refused.status == 2);
        CHECK(refused.err.find("this checkpoint is of another run") != std::string::npos);
    }
}

TEST_CASE("reductions that cannot be") {
    use_cache();
    const Outcome unknown = hvi_gen({"run", "kepler", "--reduce", "min(x), median(y)"});
    CHECK(unknown.status == 2);
    CHECK(unknown.out.empty());
    CHECK(unknown.err == "error: there is no `median` of a column\n"
                         "  --reduce: min(x), median(y)\n"
                         "                    ^~~~~~\n"
                         "help: did you mean `mean`?\n");
    const Outcome unseen =
        hvi_gen({"run", "kepler", "--reduce", "min(x)", "--only", "table,picture"});
    CHECK(unseen.status == 2);
    CHECK(unseen.err == "error: what --reduce finds is said in the summary, which is left out\n"
                        "  --only: table,picture\n"
                        "          ^~~~~~~~~~~~~\n"
                        "help: add it, as in --only table,summary\n");
}
