// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/passes.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>
#include <vector>

#include "generator/lower/homogeneous.hpp"
#include "generator/lower/tangent.hpp"
#include "generator/pipeline/refusals.hpp"

namespace hvi::gen {

namespace {

/// The stepper of what a pass makes of the scene, with loops or without.
SceneStepper stepper_after(const SystemPass& pass, const Method& method, const Scene& scene,
                           StepperWishes wishes) {
    wishes.invariants = false;
    const std::vector<SystemPass> passes{pass};
    return by_unrolling(
        scene, {wishes.unroll, wish_without_loops(wishes)},
        [&](const UnrollDecision& why) {
            return scene_stepper(method, lowered_with_loops(scene, why, passes), wishes);
        },
        [&](WrittenOutScene written, const UnrollDecision& why) {
            return scene_stepper(
                method, lowered_written_out(scene, std::move(written), why, passes), wishes);
        });
}

/// Throws InputError for a method that determines the momenta from velocities, where one of them
/// has no velocity.
void check_nodes(const Method& method, std::string_view what) {
    if (!std::holds_alternative<GalerkinRule>(derive_any(method))) return;
    throw InputError(
        fmt::format("{} is not built for methods with more nodes than functions", what),
        method.place, "these determine p from v, and it takes a momentum more, without a v");
}

/// A Hamiltonian without loops, and why it has none.
struct WithoutLoops {
    WrittenOutScene scene;
    UnrollDecision why;
};

/// The scene for what takes no other. Throws InputError for a Lagrangian and for loops, too.
WithoutLoops written_out(const Scene& scene, const StepperWishes& wishes, std::string_view what) {
    refuse_scale(scene, what);
    check_motion(scene, what);
    const Place place = whole(scene.function.source);
    if (scene.side == Side::lagrangian)
        throw InputError(fmt::format("{} is not built for a Lagrangian", what), place,
                         "write the Hamiltonian, which `hvi-gen scheme` prints");
    const UnrollDecision why = unroll_decision(scene, {wishes.unroll, std::string(what)});
    if (!why.writes_out)
        throw InputError(fmt::format("{} is not built where sums stay loops", what), place,
                         "without --unroll no the sums are written out, where they can be");
    return {unrolled(scene), why};
}

SceneStepper stepper_of(const Method& method, const Scene& scene, WithoutLoops without,
                        StepperWishes wishes, const std::vector<SystemPass>& passes) {
    wishes.invariants = false;
    return scene_stepper(
        method, lowered_written_out(scene, std::move(without.scene), without.why, passes), wishes);
}

/// Throws NoLoops where the momentum of a scaled time begins with what the steps compute for -H, as
/// nobody differentiates that.
void check_start_of_momentum(const System& system, const Scene& scene, std::string_view what) {
    if (scene.scale && !system.is_written_out())
        throw NoLoops(
            fmt::format("{} is not built for a scale of the time where sums stay loops", what),
            scene.scale->place);
}

}  // namespace

void check_own_functions(const Scene& scene, std::string_view what) {
    if (!scene.own.headers.empty())
        throw InputError(fmt::format("{} is not built for functions of your own", what),
                         whole(scene.function.source));
}

void check_motion(const Scene& scene, std::string_view what) {
    refuse_rotations(scene, what);
    check_own_functions(scene, what);
}

SceneStepper tangent_stepper(const Method& method, const Scene& scene, const StepperWishes& wishes,
                             std::string_view what) {
    check_motion(scene, what);
    SceneStepper result = stepper_after(with_tangent, method, scene, wishes);
    result.has_direction = true;
    return result;
}

SceneStepper sensitivity_stepper(const Method& method, const Scene& scene,
                                 const StepperWishes& wishes, const std::string& parameter,
                                 std::string_view what) {
    check_motion(scene, what);
    const auto pass = [&](System system) {
        check_start_of_momentum(system, scene, what);
        return with_sensitivity(std::move(system), parameter);
    };
    return stepper_after(pass, method, scene, wishes);
}

SceneStepper shadow_stepper(const Method& method, const Scene& scene, const StepperWishes& wishes,
                            std::string_view what) {
    WithoutLoops without = written_out(scene, wishes, what);
    check_nodes(method, what);
    return stepper_of(method, scene, std::move(without), wishes, {with_homogeneous_extension});
}

SceneStepper balance_stepper(const Method& method, const Scene& scene, const StepperWishes& wishes,
                             std::string_view what) {
    WithoutLoops without = written_out(scene, wishes, what);
    check_nodes(method, what);
    const Place place = whole(scene.function.source);
    without.scene.scale = SceneScale{.kind = TimeScale::expression,
                                     .expression = {"scale", Expression::integer(1), place},
                                     .place = place};
    return stepper_of(method, scene, std::move(without), wishes, {});
}

}  // namespace hvi::gen
