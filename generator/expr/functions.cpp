// The table of functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/functions.hpp"

#include <algorithm>
#include <array>

namespace hvi::gen {

namespace {

constexpr std::array table{
#define HVI_FUNCTION(name, latex, domain, cuts, parity, derivative)                                \
    Function{#name, 1, latex, RealDomain::domain, Cuts::cuts, Parity::parity, derivative},
#include "generator/expr/functions.def"
#undef HVI_FUNCTION
    Function{"roots", 1, "\\operatorname{roots}"},
    Function{"bspline", 2, "\\operatorname{bspline}"},
};

}  // namespace

std::span<const Function> functions() { return table; }

bool is_of_lists(std::string_view name) { return name == "roots" || name == "bspline"; }

const Function* find_function(std::string_view name) {
    const auto* found = std::find_if(table.begin(), table.end(),
                                     [&](const Function& entry) { return entry.name == name; });
    return found == table.end() ? nullptr : found;
}

}  // namespace hvi::gen
