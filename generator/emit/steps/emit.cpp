// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/emit.hpp"

#include "generator/emit/steps/header.hpp"
#include "generator/emit/text/names.hpp"

namespace hvi::gen {

namespace {

std::string text_of(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    if (step.layout == Layout::trajectories) { return emit_ensemble(method, step, options); }
    return std::visit([&](const auto& form) { return emit_one(method, step, form, options); },
                      step.form);
}

}  // namespace

std::string with_names_of_user(std::string text, const EmitOptions& options) {
    const auto make_way = [&](const auto& invariants) {
        for (const auto& invariant : invariants) { text = with_other_tables(text, invariant.name); }
    };
    if (options.wishes.invariants) { make_way(options.system->invariants); }
    if (options.loops != nullptr) { make_way(options.loops->system.invariants); }
    return text;
}

std::string emit(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    return with_names_of_user(text_of(method, step, options), options);
}

}  // namespace hvi::gen
