// Plans: values that are solved for, and values that are left out.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/exact/methods/splitting.hpp"
#include "generator/plan/lanes.hpp"
#include "generator/plan/plan.hpp"
#include "generator/support/error.hpp"
#include "tests/generator/exact/exact.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;
using Kind = StageNode::Kind;
using Where = StageValue::Place;

namespace {

const Block& only_coupled(const Step& step) {
    REQUIRE(step.coupled_blocks() == 1);
    return *std::find_if(step.blocks.begin(), step.blocks.end(),
                         [](const Block& block) { return block.coupled; });
}

using Indices = std::vector<std::size_t>;

/// How it is iterated, if it is.
Iteration iteration(const Step& step) {
    return step.iteration() == nullptr ? Iteration{} : *step.iteration();
}

bool is_tabulated_as(const Step& step, TabulatedStep::As as) {
    const auto* form = std::get_if<TabulatedStep>(&step.form);
    return form != nullptr && form->as == as;
}

Tableau strang() {
    const std::string name = "strang";
    Method method = named_method(std::make_shared<const Source>(Source{"--method", name}));
    return on_new_ground([&](const Ground& ground) { return splitting_tableau(ground, method); });
}

bool keeps_remainder(const Step& step) {
    const auto* form = std::get_if<ExplicitStep>(&step.form);
    return form != nullptr && form->sums == Sums::compensated;
}

}  // namespace

TEST_CASE("separable symplectic Euler and Verlet need no solver") {
    const Step euler = plan({tableaux::symplectic_euler()}, {.is_separable = true});
    CHECK(euler.is_explicit());
    CHECK(euler.forces_evaluated() == 1);
    CHECK(euler.velocities_evaluated() == 1);

    const Step verlet = plan({tableaux::verlet()}, {.is_separable = true});
    CHECK(verlet.is_explicit());
    CHECK(verlet.momenta.size() == 1);
    CHECK(verlet.momenta[0].stages == Indices{0, 1});
    CHECK(verlet.momenta[0].weight.is_one());
    CHECK(verlet.kept.force);
    CHECK_FALSE(verlet.kept.velocity);
    CHECK(verlet.forces_evaluated() == 1);
    CHECK(verlet.velocities_evaluated() == 1);

    const Step position = plan({tableaux::position_verlet()}, {.is_separable = true});
    CHECK(position.is_explicit());
    CHECK(position.positions.size() == 1);
    CHECK(position.kept.velocity);
    CHECK_FALSE(position.kept.force);
}

TEST_CASE("for general H nothing is explicit") {
    for (const auto& tableau : {tableaux::symplectic_euler(), tableaux::verlet(),
                                tableaux::lobatto_3(), tableaux::midpoint()}) {
        CHECK_FALSE(plan({tableau}, {.is_separable = false}).is_explicit());
    }
}

TEST_CASE("symplectic Euler for general H solves for p alone") {
    const Step step = plan({tableaux::symplectic_euler()}, {.is_separable = false});
    const Block& block = only_coupled(step);
    CHECK(block.of(Kind::P) == Indices{0});
    CHECK(block.of(Kind::Lp) == Indices{0});
    CHECK(block.of(Kind::Q).empty());
    CHECK(block.of(Kind::Lq).empty());
}

TEST_CASE("lobatto:3 solves for one force when H is separable") {
    const Step step = plan({tableaux::lobatto_3()}, {.is_separable = true});
    const Block& block = only_coupled(step);
    CHECK(block.of(Kind::Q) == Indices{1});
    CHECK(block.of(Kind::Lp) == Indices{1});
    CHECK(block.of(Kind::P) == Indices{0, 1, 2});
    CHECK(step.positions[0].place == Where::start);
    CHECK(step.positions[2].place == Where::end);
    CHECK(step.kept.force);
    CHECK(step.partner == Partner::different);
}

TEST_CASE("stages that decouple are solved one after the other") {
    for (const bool separable : {false, true}) {
        const Step step = plan({tableaux::two_midpoints()}, {.is_separable = separable});
        CHECK(step.coupled_blocks() == 2);
        CHECK(step.partner == Partner::same);
        CHECK(step.blocks.front().of(Kind::Q) == Indices{0});
    }
}

TEST_CASE("A == A~ is said where it is proved, and the contrary too") {
    const auto partner = [](const char* name) {
        return plan({derive(named_method(source(name)))}, {}).partner;
    };
    CHECK(partner("gauss:4") == Partner::same);
    CHECK(partner("gauss:7") == Partner::same);  // nodes without a closed form
    CHECK(partner("radau-left:7") == Partner::different);
    CHECK(partner("chebyshev:7") == Partner::different);
    CHECK(partner("trig3") == Partner::different);

    // The midpoint rule by a node that is 1/2, which no enclosure can prove.
    const Number half = number("cos(pi/11)+cos(3*pi/11)+cos(5*pi/11)+cos(7*pi/11)+cos(9*pi/11)");
    REQUIRE_FALSE(half.closed_form());
    Tableau midpoint = tableaux::midpoint();
    midpoint.c = {half};
    midpoint.A = {{half}};
    midpoint.A_tilde = {{Number(1) - half}};
    CHECK(plan({midpoint}, {}).partner == Partner::undecided);
}

TEST_CASE("the dump of a step is stable") {
    CHECK(
        dump(plan({tableaux::verlet()}, {.is_separable = true})) ==
        "slopes: dH/dq(q), dH/dp(p)\n"
        "tables: A != A~\n"
        "Q_1: start, weight 1/2, stages 1\n"
        "Q_2: end, weight 1/2, stages 2\n"
        "P_1: inner, weight 1, stages 1 2\n"
        "m: 0\n"
        "m: 1\n"
        "evaluate Q_1\n"
        "evaluate Lp_1\n"
        "evaluate P_1\n"
        "evaluate Lq_1\n"
        "evaluate Q_2\n"
        "evaluate Lp_2\n"
        "kept: dH/dq\n"
        "form: explicit, plain sums\n"
        "vectors: the user's\n"
        "lanes: one\n"
        "P_1 = P_2 is evaluated once: these stages are equal\n"
        "Q_1 is not solved for: it is q at the start of the step\n"
        "Q_2 takes no sum of its own: it is q at the end of the step\n"
        "no solver: no stage depends on itself: the step is kicks and drifts in turn\n"
        "no compensated summation: the error of the step is far above round-off\n"
        "one force a step is not evaluated: the last one of a step is the first one of the next\n");
}

TEST_CASE("explicit compositions from order 6 on keep what rounding cuts off") {
    const auto keeps = [](const Tableau& tableau, const char* name, bool separable,
                          Lanes lanes = Lanes::none) {
        const auto text = std::make_shared<const Source>(Source{"--compose", name});
        const Step step =
            plan({tableau, named_composition(text)}, {.is_separable = separable}, {.lanes = lanes});
        const std::string said = "compensated summation: errors of order ";
        CHECK((dump(step).find("\n" + said) != std::string::npos) == keeps_remainder(step));
        return keeps_remainder(step);
    };
    CHECK_FALSE(keeps_remainder(plan({tableaux::verlet()}, {.is_separable = true})));
    CHECK_FALSE(keeps(tableaux::verlet(), "yoshida:4", true));
    CHECK_FALSE(keeps(tableaux::verlet(), "suzuki:4", true));
    CHECK(keeps(tableaux::verlet(), "yoshida:6", true));
    CHECK(keeps(tableaux::verlet(), "kahan-li:8", true));
    CHECK(keeps(tableaux::verlet(), "yoshida:6", true, Lanes::ensemble));
    CHECK_FALSE(keeps(tableaux::verlet(), "yoshida:4", true, Lanes::ensemble));
    // Sums of steps that are solved for are always compensated.
    CHECK_FALSE(keeps(tableaux::verlet(), "yoshida:6", false));
    CHECK_FALSE(keeps(tableaux::midpoint(), "yoshida:8", true));
}

TEST_CASE("coefficients that depend on a parameter are quotients, constants are left out") {
    // Row 1 of m is 0 and row 3 is 1, m_2,2 is 1/2.
    const Step step = plan({derive(method("1, cos(w*tau), sin(w*tau)", "0, 1/2, 1"))}, {});
    REQUIRE(step.from_parameter);
    const FromParameter& from = *step.from_parameter;
    CHECK(from.numbers.parameter == "w");
    CHECK(from.numbers.weights.size() == 3);
    CHECK(from.numbers.others.size() == 2);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            CHECK(from.m[i][j].has_value() == (i == 1 && j != 1));
        }
    }
    CHECK(from.m[1][2]->b == 2);
    CHECK(iteration(step).extrapolation.empty());
}

TEST_CASE("the times of stages depend on a parameter where nodes do") {
    const auto times = [](const char* basis, const char* nodes) {
        return plan({derive(method(basis, nodes))}, {.depends_on_time = true});
    };
    const Step fixed = times("1, tau, cos(w*tau), sin(w*tau)", "0, 1/3, 2/3, 1");
    REQUIRE(fixed.from_parameter);
    CHECK(fixed.from_parameter->c == std::vector<std::optional<std::size_t>>(4));
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK((fixed.c.at(i) - tableaux::ratio(static_cast<long>(i), 3)).is_zero());
    }
    const Step moving = times("1, tau, tau^2", "0, w, 1");
    REQUIRE(moving.from_parameter);
    CHECK_FALSE(moving.from_parameter->c.at(0));
    CHECK(moving.from_parameter->c.at(1));
    CHECK_FALSE(moving.from_parameter->c.at(2));
}

TEST_CASE("the places without a method are among the choices") {
    const auto choices = [](const char* basis, const char* nodes) {
        std::string text;
        for (const Decision& decision : plan({derive(method(basis, nodes))}, {}).decisions) {
            text += decision.what + ": " + decision.why + '\n';
        }
        return text;
    };
    using Catch::Matchers::Contains;
    const std::string four = choices("1, tau, cos(w*tau), sin(w*tau)", "0, 1/3, 2/3, 1");
    CHECK_THAT(four, Contains("w = 3*pi*k, k = +-1, +-2, ...: coefficients are infinite there"));
    // tan(w/2) = w/2.
    CHECK_THAT(four, Contains("+-8.98682, "));
    CHECK_THAT(four, Contains("(all of size below 32): a weight is zero there"));
    // b = (1 - 1/(6 w), 1/(6 w (1 - w)), ...) of the nodes 0, w, 1.
    const std::string node = choices("1, tau, tau^2", "0, w, 1");
    CHECK_THAT(node, Contains("no method at w = 0: coefficients are infinite there"));
    CHECK_THAT(node, Contains("w = 1 (all of size below 32): coefficients are infinite there"));
    CHECK_THAT(node, Contains("w = 0.333333, 0.666667 (all"));
}

TEST_CASE("a parameter that cancels is no argument") {
    const Step step = plan({derive(method("w, w*tau", "gauss:2"))}, {});
    CHECK_FALSE(step.from_parameter);
    CHECK_FALSE(iteration(step).extrapolation.empty());
}

TEST_CASE("the equations of Newton's method decouple by the eigenvalues of A A~") {
    const auto modes = [](const char* method) {
        const Step step =
            plan({derive(named_method(source(method)))},
                 {.is_separable = true, .kinetic_is_quadratic = true}, {.solver = Solver::newton});
        return std::get<VelocityStep>(step.form).modes;
    };
    // Gauss 2: roots of x^2 - x/12 + 1/144, as A A~ = A^2 and A has the eigenvalues of the Pade
    // approximant (2,2) of exp, (3 +- i sqrt(3))/12.
    const auto gauss = modes("gauss:2");
    REQUIRE(gauss);
    CHECK(gauss->real_ones == 0);
    CHECK(gauss->real_parts[0] == Approx(1.0 / 24).epsilon(1e-15));
    CHECK(gauss->imaginary_parts[0] == Approx(std::sqrt(3.0) / 24).epsilon(1e-15));
    // Lobatto: published with 40 digits elsewhere; nodes 0 and 1 are not solved for.
    const auto lobatto = modes("lobatto:3");
    REQUIRE(lobatto);
    CHECK(lobatto->real_ones == 1);
    CHECK(lobatto->real_parts == std::vector<double>{1.0 / 24});
    const auto lobatto_4 = modes("lobatto:4");
    REQUIRE(lobatto_4);
    CHECK(lobatto_4->real_parts[0] == Approx(1.0 / 60).epsilon(1e-15));
    CHECK(lobatto_4->imaginary_parts[0] == Approx(1.0 / 60).epsilon(1e-15));
    CHECK(modes("gauss:8")->imaginary_parts.size() == 4);
    CHECK(modes("gauss:3")->real_ones == 1);
}

TEST_CASE("who solves the equations") {
    const auto takes_newton = [](const char* method, bool quadratic, bool in_time, Solver solver) {
        const Step step = plan({derive(named_method(source(method)))},
                               {.is_separable = quadratic,
                                .depends_on_time = in_time,
                                .kinetic_is_quadratic = quadratic},
                               {.solver = solver});
        if (const auto* positions = std::get_if<VelocityStep>(&step.form)) {
            CHECK(positions->modes.has_value() == positions->iteration.takes_newton());
        }
        return iteration(step).takes_newton();
    };
    CHECK(takes_newton("gauss:2", true, false, Solver::automatic));
    CHECK(takes_newton("gauss:2", false, false, Solver::automatic));
    CHECK(takes_newton("gauss:2", true, true, Solver::automatic));
    CHECK(takes_newton("gauss:2", false, true, Solver::automatic));
    CHECK(takes_newton("gauss:2", false, false, Solver::newton));
    CHECK_FALSE(takes_newton("gauss:2", true, false, Solver::fixed_point));
    CHECK_FALSE(takes_newton("stormer-verlet", true, false, Solver::automatic));
}

TEST_CASE("both slopes at once, where both are unknown") {
    const auto joint = [](const char* method, bool separable, bool pays) {
        const Step step = plan(
            {derive(named_method(source(method)))},
            {.is_separable = separable, .costs = {.by_q = pays ? 200.0 : 100.0, .joint = 100.0}},
            {.solver = Solver::automatic});
        return step.slopes == Slopes::joint;
    };
    CHECK(joint("gauss:3", false, true));
    CHECK(joint("midpoint", false, true));
    CHECK_FALSE(joint("gauss:3", true, true));
    CHECK_FALSE(joint("gauss:3", false, false));
    // P_1 is solved for, then Q_2: dH/dp at the start has its P when dH/dq has.
    CHECK_FALSE(joint("stormer-verlet", false, true));
    CHECK_FALSE(joint("symplectic-euler", false, true));
}

TEST_CASE("a quadratic H is tabulated, unless that costs too much") {
    const auto tabulated = [](const char* method, SystemProperties system,
                              StepWishes wishes = {.solver = Solver::automatic}) {
        system.has_linear_map = true;
        return std::holds_alternative<TabulatedStep>(
            plan({derive(named_method(source(method)))}, system, wishes).form);
    };
    const char* gauss = "gauss:2";
    CHECK(tabulated(gauss, {.is_separable = true, .degrees_of_freedom = 1}));
    CHECK(tabulated(gauss, {.is_separable = false, .degrees_of_freedom = 1}));
    CHECK(tabulated(gauss, {.is_separable = true, .degrees_of_freedom = 4}));
    CHECK(tabulated(gauss, {.is_separable = false, .degrees_of_freedom = 2}));
    // Four slopes of each degree of freedom; two with the midpoint rule.
    CHECK(tabulated(gauss, {.is_separable = true, .degrees_of_freedom = 16}));
    CHECK_FALSE(tabulated(gauss, {.is_separable = true, .degrees_of_freedom = 17}));
    CHECK(tabulated("midpoint", {.is_separable = true, .degrees_of_freedom = 32}));
    CHECK_FALSE(tabulated("midpoint", {.is_separable = true, .degrees_of_freedom = 33}));
    CHECK(tabulated("midpoint", {.is_separable = false, .degrees_of_freedom = 32}));
    CHECK_FALSE(tabulated("midpoint", {.is_separable = false, .degrees_of_freedom = 33}));

    const SystemProperties one = {.is_separable = true, .degrees_of_freedom = 1};
    CHECK_FALSE(tabulated("stormer-verlet", one));  // explicit
    const Step seen =
        plan({derive(named_method(source(gauss)))}, one, {.solver = Solver::automatic});
    CHECK_FALSE(std::holds_alternative<TabulatedStep>(seen.form));
    CHECK_FALSE(tabulated(gauss, one, {.solver = Solver::of_user}));
    CHECK_FALSE(tabulated(gauss, one, {.solver = Solver::automatic, .curve = true}));
    CHECK_FALSE(tabulated(gauss, one, {.solver = Solver::automatic, .action = true}));
}

TEST_CASE("shears for T(p) + U(q) and for one degree of freedom, else a product") {
    const auto sheared = [](bool separable, std::size_t n) {
        return is_tabulated_as(
            plan({derive(method("gauss:2"))},
                 {.is_separable = separable, .has_linear_map = true, .degrees_of_freedom = n},
                 {.solver = Solver::automatic}),
            TabulatedStep::As::shears);
    };
    CHECK(sheared(true, 1));
    CHECK(sheared(true, 2));
    CHECK(sheared(false, 1));
    CHECK_FALSE(sheared(false, 2));
}

TEST_CASE("a degenerate H has no shears, and none are spoken of as if they were there") {
    const Step step = plan({derive(method("chebyshev:3"))},
                           {.is_separable = false,
                            .has_linear_map = true,
                            .is_degenerate = true,
                            .degrees_of_freedom = 1},
                           {.solver = Solver::automatic});
    CHECK(is_tabulated_as(step, TabulatedStep::As::matrix));
    for (const Decision& decision : step.decisions) {
        INFO(decision.what << ": " << decision.why);
        CHECK(decision.why.find("product of three shears") == std::string::npos);
    }
}

TEST_CASE("why the step of a quadratic H is iterated is among the choices") {
    const auto reason = [](const SystemProperties& system, Solver solver) -> std::string {
        for (const Decision& decision :
             plan({derive(method("gauss:2"))}, system, {.solver = solver}).decisions) {
            if (decision.what == "iterated, though H is quadratic") { return decision.why; }
        }
        return "";
    };
    SystemProperties system = {.has_linear_map = true, .degrees_of_freedom = 2};
    CHECK(reason(system, Solver::automatic).empty());
    system.is_separable = true;
    CHECK(reason(system, Solver::automatic).empty());
    system.degrees_of_freedom = 20;
    CHECK(reason(system, Solver::automatic) == "its matrix has 80 unknowns, above 64");
    CHECK(reason(system, Solver::newton).empty());
}

TEST_CASE("a splitting of three parts takes their flows in turn, and those in a row as one") {
    const Step step =
        plan({strang()}, {.degrees_of_freedom = 2, .container = Container::arrays, .parts = 3});
    const auto* form = std::get_if<FlowStep>(&step.form);
    REQUIRE(form != nullptr);
    CHECK(step.is_explicit());
    std::vector<std::size_t> parts;
    REQUIRE(form->rounds.size() == 1);
    for (const FlowStep::Move& move : form->rounds[0].moves) { parts.push_back(move.part); }
    CHECK(parts == Indices{0, 1, 2, 1, 0});
    REQUIRE(form->fractions.size() == 3);
    CHECK(form->fractions[0].size() == 2);  // alone, and joined with the next step
    CHECK((form->fractions[0][0] - Number(1) / Number(2)).is_zero());
    CHECK((form->fractions[1][0] - Number(1) / Number(2)).is_zero());
    CHECK(form->fractions[2][0].is_one());
}

TEST_CASE("flows of eight trajectories join none of steps in a row") {
    const SystemProperties system{
        .degrees_of_freedom = 2, .container = Container::arrays, .parts = 2};
    const Step one = plan({strang()}, system);
    CHECK(one.layout == Layout::one);
    CHECK(std::get<FlowStep>(one.form).joined);
    CHECK(may_go_side_by_side(one));
    const Step eight = plan({strang()}, system, {.lanes = Lanes::ensemble});
    CHECK(eight.layout == Layout::trajectories);
    const FlowStep& form = std::get<FlowStep>(eight.form);
    CHECK_FALSE(form.joined);
    CHECK(form.fractions[0].size() == 1);
    CHECK(form.flows() == 3);
}

TEST_CASE("flows that turn bodies are of one trajectory, or of eight") {
    const SystemProperties system{
        .degrees_of_freedom = 6, .rotations = 1, .container = Container::arrays, .parts = 2};
    const Step one = plan({strang()}, system);
    CHECK(obstacle_to_ensemble(one).empty());
    CHECK(may_go_side_by_side(one));
    CHECK(obstacle_to_threads(one) == "flows of parts are to come");
    const Step eight = plan({strang()}, system, {.lanes = Lanes::ensemble});
    CHECK(eight.layout == Layout::trajectories);
    const FlowStep& form = std::get<FlowStep>(eight.form);
    CHECK(form.moving == FlowStep::Moving::bodies);
    CHECK_FALSE(form.joined);
}

TEST_CASE("flows beside a time are of one trajectory, and one part moves the time") {
    const SystemProperties system{.depends_on_time = true,
                                  .degrees_of_freedom = 1,
                                  .container = Container::arrays,
                                  .parts = 2,
                                  .clock = 1};
    const Step step = plan({strang()}, system, {.lanes = Lanes::ensemble});
    CHECK(step.layout == Layout::one);
    CHECK(std::get<FlowStep>(step.form).clock == 1);
    CHECK(step.depends_on_time());
    CHECK(step.c.empty());
    CHECK(obstacle_to_ensemble(step) == "flows beside a time are built for one trajectory alone");
    CHECK_FALSE(may_go_side_by_side(step));
}
