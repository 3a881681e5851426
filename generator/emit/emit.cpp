// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/emit.hpp"

#include "generator/emit/header.hpp"

namespace hvi::gen {

std::string emit(const Tableau& tableau, const Scheme& scheme, const EmitOptions& options) {
    if (scheme.is_tabulated) { return emit_linear(tableau, scheme, options); }
    return scheme.is_explicit() ? emit_explicit(tableau, scheme, options)
                                : emit_implicit(tableau, scheme, options);
}

}  // namespace hvi::gen
