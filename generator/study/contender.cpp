// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/contender.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "generator/exact/methods/order.hpp"
#include "generator/exact/methods/rule_properties.hpp"
#include "generator/pipeline/refusals.hpp"
#include "generator/scene/start.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr int highest_order = 16;  // that is looked for

int order_of(const Tableau& tableau) { return orders(tableau, highest_order).general.order; }

/// For a quadratic kinetic energy; for other H it is at most this.
int order_of(const GalerkinRule& rule) { return nystrom_order(rule, highest_order).order; }

constexpr const char* reference_method = "gauss:10";

/// `gauss:4 (3 sweeps)`.
std::string with_sweeps(const std::string& title, int sweeps) {
    if (sweeps == 0) return title;
    return fmt::format("{} ({} sweep{})", title, sweeps, sweeps == 1 ? "" : "s");
}

}  // namespace

StudiedMethod studied(ExactMethod method) {
    const auto of_base = [](const auto& base) { return order_of(base); };
    const int order = composed_order(std::visit(of_base, method.base), method.composition);
    return {std::move(method), order};
}

bool has_exact_states(const WrittenOutScene& scene) {
    return !scene.exact.empty() && std::holds_alternative<Hamiltonian>(scene.mechanics);
}

Contender contender(Builds& builds, const StudiedMethod& method, const LoweredScene& scene,
                    Solver solver, int sweeps) {
    StepperWishes wishes = simulation_wishes(solver, method.composition);
    wishes.sweeps.choice = sweeps;
    const SceneStepper stepper = scene_stepper(method, scene, wishes);
    check_parameter_of_method(stepper);
    const std::optional<StageCorrections>& corrections = stepper.step.corrections;
    ModuleBuild module = simulation_program(stepper).order(builds);
    module.begin_all();
    return {with_sweeps(stepper.method.title(), sweeps),
            method.order,
            std::move(module),
            corrections ? std::optional(corrections->costs) : std::nullopt,
            sweeps,
            obstacle_to_sweeps(stepper.step).empty()};
}

std::vector<Contender> contenders(Builds& builds, const std::vector<StudiedMethod>& methods,
                                  const LoweredScene& scene, int sweeps) {
    std::vector<Contender> all;
    for (const StudiedMethod& method : methods)
        all.push_back(contender(builds, method, scene, Solver::automatic));
    if (sweeps == 0) return all;
    for (std::size_t i = 0; i < methods.size(); ++i)
        if (all[i].takes_sweeps)
            all.push_back(contender(builds, methods[i], scene, Solver::automatic, sweeps));
    return all;
}

MeasureSteps measured(const Contender& contender, double until) {
    return [contender, until](std::int64_t count, double seconds) {
        return measure(contender.module.target(), {until / static_cast<double>(count), count},
                       seconds);
    };
}

Build reference_build(Builds& builds, const LoweredScene& scene) {
    if (has_exact_states(*scene.written)) return {};
    const auto name = std::make_shared<const Source>(Source{"--method", reference_method});
    return builds.order(reference_program(scene_stepper(
        named_method(name), scene, {.solver = Solver::fixed_point, .float128 = true})));
}

Reference reference(const Build& build, const WrittenOutScene& scene, double until,
                    std::int64_t count, double wanted, double seconds) {
    // Of so high an order, larger steps than the scene's may do.
    const std::int64_t begin = std::max<std::int64_t>(1, count / 16);
    if (has_exact_states(scene)) return {"exact", 0, exact_state(scene, until)};
    const ReferenceSolution found =
        find_reference(Program{built(build)}, until, begin, wanted, seconds);
    if (found.state.empty())
        throw MathError(
            fmt::format("there is no reference solution: {} in {} bits does not come to "
                        "the end",
                        reference_method, found.bits),
            {}, "give the scene an [exact] solution, or another end by `until`");
    return {fmt::format("{} in {} bits", reference_method, found.bits), found.error, found.state};
}

}  // namespace hvi::gen
