// Plans of steps in charts of rotations: stages side by side, or one after the other.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "generator/plan/lanes.hpp"
#include "generator/plan/plan.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

constexpr SystemProperties turning_body{
    .degrees_of_freedom = 3, .rotations = 1, .container = Container::arrays};

Step planned_in_chart(const char* method, StepWishes wishes,
                      const SystemProperties& system = turning_body) {
    return plan({derive(named_method(source(method)))}, system, wishes);
}

constexpr StepWishes usual_wishes{.solver = Solver::automatic, .lanes = Lanes::automatic};

bool says_side_by_side(const Step& step) {
    return std::any_of(step.decisions.begin(), step.decisions.end(), [](const Decision& decision) {
        return decision.what == "the stages are computed side by side";
    });
}

}  // namespace

TEST_CASE("stages in a chart go side by side, by fixed points, until these are slow") {
    for (const char* method : {"gauss:2", "gauss:4", "chebyshev:3", "lobatto:3", "gauss:16"}) {
        const Step step = planned_in_chart(method, usual_wishes);
        CAPTURE(method);
        CHECK(step.layout == Layout::stages);
        CHECK(step.register_width == widest_register);
        CHECK_FALSE(step.corrections);
        CHECK(says_side_by_side(step));
    }
    CHECK(planned_in_chart("gauss:2", {.solver = Solver::fixed_point, .lanes = Lanes::automatic})
              .layout == Layout::stages);
}

TEST_CASE("stages in a chart go one by one where there is one, Newton's method, or the wish") {
    CHECK(obstacle_to_stage_lanes(planned_in_chart("midpoint", usual_wishes)) ==
          "there is one stage");
    CHECK(planned_in_chart("midpoint", usual_wishes).layout == Layout::one);
    const Step newton =
        planned_in_chart("gauss:2", {.solver = Solver::newton, .lanes = Lanes::automatic});
    CHECK(newton.layout == Layout::one);
    CHECK(obstacle_to_stage_lanes(newton) ==
          "they are built for fixed points, and for these and Newton's method in turn");
    const Step alone =
        planned_in_chart("gauss:2", {.solver = Solver::automatic, .lanes = Lanes::none});
    CHECK(alone.layout == Layout::one);
    CHECK_FALSE(says_side_by_side(alone));
    SystemProperties any_size = turning_body;
    any_size.container = Container::vectors;
    CHECK(planned_in_chart("gauss:2", usual_wishes, any_size).layout == Layout::one);
}

TEST_CASE("trajectories of rotations do not go side by side") {
    const Step step = planned_in_chart("gauss:2", usual_wishes);
    CHECK(obstacle_to_ensemble(planned_in_chart("gauss:2", {.solver = Solver::fixed_point})) ==
          "charts of rotations are built for one trajectory alone");
    CHECK_FALSE(may_go_side_by_side(step));
}
