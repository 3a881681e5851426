// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/ensemble_steppers.hpp"

#include <utility>

#include "generator/cli/output_times.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/pipeline/directions.hpp"
#include "generator/pipeline/side_by_side.hpp"
#include "generator/simulate/device_program.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

StepperWishes wishes_of(const EnsembleOptions& options) {
    StepperWishes wishes = simulation_wishes(options.wishes.solver, options.wishes.composition);
    wishes.sweeps = options.wishes.sweeps;
    wishes.unroll = options.wishes.unroll;
    if (options.interpret) wishes.lanes = {Lanes::none};
    return wishes;
}

/// The steppers of the directions that MEGNO takes. Throws InputError where steps carry none.
SceneStepper directions_of(const MethodAndScene& both, const SceneStepper& stepper,
                           const StepperWishes& wishes) {
    constexpr std::string_view what = "--megno";
    refuse_scale(both.scene, what);
    if (both.scene.kinks)
        throw InputError("--megno is not built for kinks that end steps", both.scene.kinks);
    for (const IndexedEvent& event : both.scene.events)
        if (event.set) throw InputError("--megno is not built for events that jump", event.place);
    if (!stepper.system.is_written_out())
        throw InputError("--megno of an ensemble is not built where sums stay loops",
                         both.scene.place,
                         "--unroll yes writes the sums out, up to 256 degrees of freedom");
    return stepper_of_directions(stepper, both.method, both.scene, wishes, what, 1);
}

/// Returns steppers on a GPU. Throws InputError where rows cannot be taken there.
SceneStepper stepper_on_device(const MethodAndScene& both, const SceneStepper& alone,
                               const StepperWishes& wishes, const Place& cuda) {
    refuse_scale(both.scene, "--cuda");
    if (!both.scene.events.empty())
        throw InputError("--cuda is not built for events", both.scene.events.front().place);
    if (both.scene.kinks)
        throw InputError("--cuda is not built for kinks that end steps", both.scene.kinks);
    if (!alone.system.is_written_out())
        throw InputError("--cuda is not built where sums stay loops", both.scene.place,
                         "--unroll yes writes the sums out, up to 256 degrees of freedom");
    return scene_stepper(both.method, both.scene, device_wishes(wishes, cuda));
}

/// Returns steppers of many rows at once; nothing where rows are to be taken alone.
std::optional<SceneStepper> stepper_at_once(const EnsembleOptions& options,
                                            const MethodAndScene& both, const SceneStepper& alone,
                                            const StepperWishes& wishes) {
    if (options.cuda) return stepper_on_device(both, alone, wishes, *options.cuda);
    const Scene& scene = both.scene;
    const bool are_alone = options.wishes.lanes.choice == Lanes::none || options.interpret ||
                           options.reduce || !scene.events.empty() || scene.kinks;
    if (are_alone) return {};
    if (!options.megno) return stepper_side_by_side(alone, both.method, scene, wishes);
    // NOTE: with a direction, eight have no invariants.
    if (options.columns) return {};
    return tangent_stepper_side_by_side(alone, both.method, scene, wishes);
}

}  // namespace

EnsembleWork work_of(const EnsembleOptions& options, const MethodAndScene& both,
                     const RowSource& source, const SceneTimes& times) {
    const NamedExpression step = wish(times, options.step, times.step, "step"),
                          until = wish(times, options.until, times.until, "until");
    const StepperWishes wishes = wishes_of(options);
    SceneStepper stepper = scene_stepper(both.method, both.scene, wishes);
    RowPlan plan(both.scene, stepper, source.names(), step, until);
    EnsembleWork work{both.scene, std::move(stepper), std::move(plan)};
    work.wishes.looks_at_end = work.stepper.step.container == Container::vectors;
    work.wishes.growth = options.megno;
    const auto planned = [&](SceneStepper of_rows) {
        RowPlan its(both.scene, of_rows, source.names(), step, until);
        return PlannedStepper{std::move(of_rows), std::move(its)};
    };
    if (auto at_once = stepper_at_once(options, both, work.stepper, wishes))
        work.at_once.emplace(planned(std::move(*at_once)));
    if (options.megno) work.directions.emplace(planned(directions_of(both, work.stepper, wishes)));
    return work;
}

}  // namespace hvi::gen
