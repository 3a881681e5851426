// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/emit.hpp"

#include "generator/emit/steps/header.hpp"

namespace hvi::gen {

std::string emit(const Tableau& tableau, const Scheme& scheme, const EmitOptions& options) {
    if (scheme.is_tabulated) { return emit_linear(tableau, scheme, options); }
    if (scheme.has_trajectory_lanes) { return emit_ensemble(tableau, scheme, options); }
    // NOTE: the curve is made of slopes, and an explicit step keeps none.
    const bool keeps_slopes = !scheme.is_explicit() || options.wishes.curve;
    return keeps_slopes ? emit_implicit(tableau, scheme, options)
                        : emit_explicit(tableau, scheme, options);
}

}  // namespace hvi::gen
