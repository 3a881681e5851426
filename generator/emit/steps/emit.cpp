// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/emit.hpp"

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

std::string emit(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    if (step.layout == Layout::trajectories) { return emit_ensemble(method, step, options); }
    return std::visit([&](const auto& form) { return emit_one(method, step, form, options); },
                      step.form);
}

}  // namespace hvi::gen
