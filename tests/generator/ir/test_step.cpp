// The record of a step: what contradicts itself is found, and steps are the same where their texts
// are.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/plan/plan.hpp"
#include "tests/generator/exact/exact.hpp"
#include "tests/generator/ir/is_found.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;

namespace {

Step positions_step() {
    return plan({derive(method("gauss:3"))}, {.is_separable = true, .kinetic_is_quadratic = true},
                {.solver = Solver::automatic});
}

}  // namespace

TEST_CASE("a step that contradicts itself is found") {
    const Step verlet = plan({tableaux::verlet()}, {.is_separable = true});
    CHECK(is_found<Step>(verlet, [](Step& step) { step.m.pop_back(); }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.blocks.pop_back(); }));
    CHECK(is_found<Step>(verlet, [](Step& step) { std::swap(step.blocks[1], step.blocks[2]); }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.blocks.push_back(step.blocks.front()); }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.blocks.front().coupled = true; }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.slopes = Slopes::one_by_one; }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.layout = Layout::stages; }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.form = TabulatedStep{}; }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.form = PairStep{Iteration{}}; }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.c.emplace_back(0); }));
    CHECK(is_found<Step>(verlet, [](Step& step) { step.in_a_row.emplace_back(1); }));
    CHECK(is_found<Step>(verlet,
                         [](Step& step) { step.positions[1].place = StageValue::Place::start; }));

    const Step gauss = positions_step();
    const auto form = [](Step& step) -> VelocityStep& { return std::get<VelocityStep>(step.form); };
    CHECK(is_found<Step>(gauss, [&](Step& step) { form(step).form.n.pop_back(); }));
    CHECK(
        is_found<Step>(gauss, [&](Step& step) { form(step).rounded.n[1][0][2] = Dyadic(1, -3); }));
    CHECK(is_found<Step>(gauss, [&](Step& step) { form(step).rounded.c[0][0].reset(); }));
    CHECK(is_found<Step>(gauss, [&](Step& step) { form(step).form.c.pop_back(); }));
    CHECK(is_found<Step>(gauss,
                         [&](Step& step) { form(step).iteration.extrapolation[0].last.clear(); }));
    CHECK(is_found<Step>(
        gauss, [&](Step& step) { form(step).iteration.extrapolation[0].before->pop_back(); }));
    CHECK(is_found<Step>(gauss, [&](Step& step) {
        form(step).iteration.extrapolation.push_back(form(step).iteration.extrapolation[0]);
    }));
    CHECK(is_found<Step>(gauss, [](Step& step) { step.kept.velocity = true; }));
    CHECK(is_found<Step>(gauss, [](Step& step) { step.form = ExplicitStep{}; }));

    const Step pairs = plan({tableaux::lobatto_3()}, {.is_separable = false});
    const auto mt = [](Step& step) -> RoundedMatrix& {
        return std::get<PairStep>(step.form).coefficients.mt;
    };
    CHECK(is_found<Step>(pairs, [&](Step& step) { mt(step)[0][1][3] = Dyadic(1, -2); }));
    CHECK(is_found<Step>(pairs, [&](Step& step) { mt(step)[1][1][0].reset(); }));
    CHECK(is_found<Step>(pairs, [&](Step& step) { mt(step).pop_back(); }));
}

TEST_CASE("a step of stages side by side that contradicts itself is found") {
    const EvaluationCosts costs{.by_q = 9, .by_p_at_q = 1, .joint = 90, .second = 3};
    const StepWishes wishes{.solver = Solver::automatic, .lanes = Lanes::automatic};
    const Step positions = plan({derive(method("gauss:3"))},
                                {.is_separable = true,
                                 .kinetic_is_quadratic = true,
                                 .degrees_of_freedom = 2,
                                 .linear = StiffComponents{{1}},
                                 .costs = costs},
                                wishes);
    REQUIRE(positions.corrections);
    REQUIRE(std::get<StiffComponents>(positions.corrections->linear).components.size() == 1);
    CHECK(is_found<Step>(positions, [](Step& step) { step.layout = Layout::one; }));
    CHECK(is_found<Step>(positions, [](Step& step) { step.register_width = 2; }));
    CHECK(is_found<Step>(positions, [](Step& step) { step.shared_slopes = 1; }));
    CHECK(is_found<Step>(positions, [](Step& step) { step.corrections->linear = {}; }));
    CHECK(is_found<Step>(positions, [](Step& step) { step.corrections->modes.to.pop_back(); }));
    CHECK(is_found<Step>(positions, [](Step& step) { step.corrections->costs.sweep = 0; }));
    const Step pairs = plan({derive(method("gauss:3"))},
                            {.degrees_of_freedom = 2, .costs = costs, .shared_slopes = 3}, wishes);
    REQUIRE(pairs.corrections);
    CHECK(pairs.shared_slopes == 3);
    CHECK(is_found<Step>(pairs, [](Step& step) { step.partner = Partner::different; }));
    CHECK(is_found<Step>(pairs, [](Step& step) { step.slopes = Slopes::joint; }));
    CHECK(
        is_found<Step>(pairs, [](Step& step) { step.corrections->linear = StiffComponents{{0}}; }));
}

TEST_CASE("a step of the general Galerkin form that contradicts itself is found") {
    const Step curve = plan({derive_any(method("1, tau", "gauss:3"))}, {.degrees_of_freedom = 1},
                            {.solver = Solver::automatic});
    const auto form = [](Step& step) -> GalerkinStep& { return std::get<GalerkinStep>(step.form); };
    CHECK(
        is_found<Step>(curve, [&](Step& step) { form(step).rounded.A[0][1][2] = Dyadic(1, -3); }));
    CHECK(
        is_found<Step>(curve, [&](Step& step) { form(step).rounded.X[0][1][1] = Dyadic(1, -3); }));
    CHECK(is_found<Step>(curve, [&](Step& step) { form(step).rounded.B[0][0].reset(); }));
    CHECK(is_found<Step>(curve, [&](Step& step) { form(step).rounded.D.pop_back(); }));
    CHECK(is_found<Step>(curve, [&](Step& step) { form(step).form.phi.pop_back(); }));
    CHECK(is_found<Step>(curve, [&](Step& step) { form(step).extrapolation->P->pop_back(); }));
    CHECK(is_found<Step>(curve, [](Step& step) { step.slopes = Slopes::one_by_one; }));
    CHECK(is_found<Step>(curve, [](Step& step) { step.layout = Layout::stages; }));
    CHECK(is_found<Step>(curve, [](Step& step) { step.blocks.clear(); }));
    Step other = curve;
    other.in_a_row = {Number(1)};
    CHECK_FALSE(other == curve);
}

TEST_CASE("of the curve of an L momenta are not extrapolated: they are not solved for") {
    const Step curve =
        plan({derive_any(method("1, tau", "gauss:3"))},
             {.side = Side::lagrangian, .degrees_of_freedom = 1}, {.solver = Solver::automatic});
    const auto extrapolation = [](auto& step) -> auto& {
        return *std::get<GalerkinStep>(step.form).extrapolation;
    };
    CHECK(extrapolation(curve).W.size() == 2);
    CHECK_FALSE(extrapolation(curve).P);
    CHECK(is_found<Step>(curve, [&](Step& step) {
        extrapolation(step).P = NumberMatrix(3, NumberVector(3, Number(1)));
    }));
}

TEST_CASE("steps are equal where nothing is decided differently") {
    const Step gauss = positions_step();
    CHECK(gauss == positions_step());
    CHECK_FALSE(gauss == plan({tableaux::verlet()}, {.is_separable = true}));
    Step other = gauss;
    other.m[0][0] = other.m[0][0] + Number(1) / Number(1000000);
    CHECK_FALSE(gauss == other);
    other = gauss;
    std::get<VelocityStep>(other.form).iteration.solver = Solver::newton;
    CHECK_FALSE(gauss == other);
    other = gauss;
    other.layout = Layout::stages;
    CHECK_FALSE(gauss == other);
}

TEST_CASE("what cannot be had leaves a step that does not contradict itself") {
    // An explicit step with a curve keeps its slopes, which trajectories side by side do not.
    const Step curved = plan({tableaux::verlet()}, {.is_separable = true},
                             {.lanes = Lanes::ensemble, .curve = true});
    CHECK(curved.layout == Layout::one);
    const Step plain =
        plan({tableaux::verlet()}, {.is_separable = true}, {.lanes = Lanes::ensemble});
    CHECK(plain.layout == Layout::trajectories);
    const Step thread = plan({tableaux::verlet()}, {.is_separable = true}, {.lanes = Lanes::gpu});
    CHECK(thread.layout == Layout::threads);
    const Step no_thread =
        plan({tableaux::verlet()}, {.is_separable = true}, {.lanes = Lanes::gpu, .curve = true});
    CHECK(no_thread.layout == Layout::one);
}
