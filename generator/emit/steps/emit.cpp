// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/emit.hpp"

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/text/names.hpp"

namespace hvi::gen {

namespace {

std::string text_of(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    switch (step.layout) {
    case Layout::trajectories: return emit_ensemble(method, step, options);
    case Layout::threads: return emit_threads(method, step, options);
    case Layout::sites: return emit_sites(method, step, options);
    case Layout::one:
    case Layout::stages:
    case Layout::components: break;
    }
    return std::visit([&](const auto& form) { return emit_one(method, step, form, options); },
                      step.form);
}

}  // namespace

bool has_seldom_solvers(const Step& step) {
    const Iteration* iteration = step.iteration();
    return iteration != nullptr && iteration->solver == Solver::automatic && !step.takes_several();
}

std::string emit_class(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    std::string text = text_of(method, step, options);
    if (!options.wishes.invariants) { return text; }
    // NOTE: tables of the stepper give way to invariants that are members.
    for (const SystemValue& invariant : options.system->invariants) {
        text = with_other_tables(text, invariant.name);
    }
    return text;
}

std::string emit(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    return banner(method, step, options) + "\n#pragma once\n\n" + emit_class(method, step, options);
}

}  // namespace hvi::gen
