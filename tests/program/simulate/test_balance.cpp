// The balance of the energy where H depends on the time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

std::string driven(const std::string& H, const std::string& more = "") {
    return "hamiltonian = \"" + H +
           "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\ninitial = {q = 1, p = \"1/2\"}\n"
           "run = {method = \"stormer-verlet\", step = \"1/10\", until = 20}\n" +
           more;
}

/// The largest size of the balance and that at the end; nothing where there is no such line.
std::pair<double, double> balance(const SceneRun& run) {
    for (const std::string& line : lines_of(run.outcome.out)) {
        if (line.rfind("balance ", 0) != 0) continue;
        const std::size_t largest = line.find(" is ") + 4, last = line.find("most, ") + 6;
        return {std::stod(line.substr(largest)), std::stod(line.substr(last))};
    }
    return {-1, -1};
}

}  // namespace

TEST_CASE("the balance has the errors of the method") {
    // Midpoint rule keeps p^2 + q^2, and takes the integral of -sin(t) by its rule: the balance is
    // (1 - cos(t)) ((h/2)/sin(h/2) - 1).
    const double h = 0.1, factor = h / 2 / std::sin(h / 2) - 1;
    double largest = 0;
    for (int k = 0; k <= 200; ++k) largest = std::max(largest, factor * (1 - std::cos(k * h)));
    const SceneRun run = run_scene(driven("(p^2 + q^2)/2 + cos(t)"), "--shadow --method midpoint");
    INFO(run.outcome.out << run.outcome.err);
    CHECK(balance(run).first == Approx(largest).epsilon(0.005));
    CHECK(balance(run).second == Approx(factor * (1 - std::cos(20.0))).epsilon(0.005));
    CHECK(run.outcome.err.empty());
    CHECK(run.outcome.out.find("\nenergy") == std::string::npos);
}

TEST_CASE("it falls with the order of the method") {
    const std::string scene = driven("p^2/2 - cos(q - cos(t))");
    const auto largest = [&](const std::string& how) {
        const SceneRun run = run_scene(scene, "--shadow " + how);
        INFO(run.outcome.out << run.outcome.err);
        return balance(run).first;
    };
    CHECK(largest("") / largest("--step 1/20") == Approx(4).epsilon(0.1));
    CHECK(largest("--interpret") == Approx(largest("")).epsilon(0.01));
    CHECK(largest("--method gauss:2 --step 1/5") / largest("--method gauss:2") ==
          Approx(16).epsilon(0.3));
    CHECK(largest("--method gauss:8") < 1e-13);
    CHECK(largest("--compose suzuki:4") < largest("") / 100);
    // Another force on the way would be 1 off, and so would the energy alone.
    CHECK(largest("--step 2") > 0.1);
}

TEST_CASE("a run without the time has no balance, and one with jumps is refused") {
    CHECK(balance(run_scene(driven("p^2/2 + q^2/2"), "--shadow")).first == -1);
    const SceneRun jumps = run_scene(
        driven("p^2/2 + q*(1 + cos(t)/9)",
               "[events.floor]\nzero = \"q\"\ndirection = \"down\"\nset = {p = \"-p\"}\n"),
        "--shadow");
    CHECK(jumps.outcome.status == 2);
    CHECK(jumps.outcome.err.find("--shadow is not built for events that jump") !=
          std::string::npos);
    const SceneRun scaled =
        run_scene(driven("p^2/2 + q^2/2 + q*cos(t)", "[time]\nscale = \"1 + q^2\"\n"),
                  "--shadow --method gauss:2");
    CHECK(scaled.outcome.status == 2);
}
