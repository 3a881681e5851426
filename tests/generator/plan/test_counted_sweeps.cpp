// Plans of counted sweeps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <sstream>
#include <string>
#include <variant>

#include <catch2/catch.hpp>

#include "generator/plan/lanes.hpp"
#include "generator/plan/plan.hpp"
#include "tests/generator/exact/exact.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;

namespace {

constexpr SystemProperties quadratic_kinetic{.is_separable = true, .kinetic_is_quadratic = true};

Step swept(const char* method, const SystemProperties& system, Lanes lanes = Lanes::none) {
    return plan({derive(named_method(source(method)))}, system,
                {.solver = Solver::sweeps, .sweeps = 3, .lanes = lanes});
}

bool has_decision(const Step& step, const std::string& what) {
    return std::any_of(step.decisions.begin(), step.decisions.end(),
                       [&](const Decision& decision) { return decision.what == what; });
}

/// The tables of starting values in the record.
std::string starting_tables(const Step& step) {
    std::istringstream lines(dump(step));
    std::string tables;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("N:", 0) == 0 || line.rfind("N_before:", 0) == 0) tables += line + '\n';
    return tables;
}

}  // namespace

TEST_CASE("counted sweeps are a decision of their own, and stand in the record") {
    for (const SystemProperties& system : {SystemProperties{}, quadratic_kinetic}) {
        const Step step = swept("gauss:4", system);
        REQUIRE(step.iteration() != nullptr);
        CHECK(step.iteration()->counts_sweeps());
        CHECK(step.iteration()->sweeps == 3);
        CHECK_FALSE(step.iteration()->takes_newton());
        CHECK(has_decision(step,
                           "explicit: exactly 3 sweeps of fixed points, and a last evaluation"));
        CHECK(dump(step).find("solver: sweeps\nsweeps: 3\n") != std::string::npos);
    }
}

TEST_CASE("counted sweeps begin as those to round-off do") {
    for (const char* method : {"gauss:2", "gauss:4", "gauss:8"}) {
        const Step counted = swept(method, quadratic_kinetic),
                   other = plan({derive(named_method(source(method)))}, quadratic_kinetic,
                                {.solver = Solver::fixed_point});
        CHECK_FALSE(starting_tables(counted).empty());
        CHECK(starting_tables(counted) == starting_tables(other));
    }
}

TEST_CASE("where nothing is iterated no sweeps are counted") {
    CHECK(swept("stormer-verlet", quadratic_kinetic).iteration() == nullptr);
    SystemProperties linear = quadratic_kinetic;
    linear.has_linear_map = true;
    linear.degrees_of_freedom = 1;
    CHECK(std::holds_alternative<TabulatedStep>(swept("gauss:2", linear).form));
}

TEST_CASE("counted sweeps go side by side where they begin alike there") {
    CHECK(swept("gauss:4", quadratic_kinetic, Lanes::stages).layout == Layout::stages);
    CHECK_FALSE(swept("gauss:4", quadratic_kinetic, Lanes::stages).corrections);
    CHECK(swept("gauss:6", quadratic_kinetic, Lanes::ensemble).layout == Layout::trajectories);
    CHECK(may_go_side_by_side(swept("gauss:6", quadratic_kinetic)));
    CHECK_FALSE(may_go_side_by_side(swept("gauss:4", quadratic_kinetic)));
    CHECK_FALSE(obstacle_to_threads(swept("gauss:6", {})).empty());
}
