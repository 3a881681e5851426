// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/emit.hpp"

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

std::string emit(const Tableau& tableau, const Step& step, const EmitOptions& options) {
    if (step.layout == Layout::trajectories) { return emit_ensemble(tableau, step, options); }
    return std::visit([&](const auto& form) { return emit_one(tableau, step, form, options); },
                      step.form);
}

}  // namespace hvi::gen
