// The table of functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/functions.hpp"

#include <algorithm>
#include <array>

namespace hvi::gen {

namespace {

constexpr std::array<Function, 14> table{{
    {"sqrt", 1, "\\sqrt"},
    {"exp", 1, "\\exp"},
    {"log", 1, "\\log"},
    {"sin", 1, "\\sin"},
    {"cos", 1, "\\cos"},
    {"tan", 1, "\\tan"},
    {"asin", 1, "\\arcsin"},
    {"acos", 1, "\\arccos"},
    {"atan", 1, "\\arctan"},
    {"sinh", 1, "\\sinh"},
    {"cosh", 1, "\\cosh"},
    {"tanh", 1, "\\tanh"},
    {"roots", 1, "\\operatorname{roots}"},
    {"bspline", 2, "\\operatorname{bspline}"},
}};

}  // namespace

std::span<const Function> functions() { return table; }

bool is_of_lists(std::string_view name) { return name == "roots" || name == "bspline"; }

const Function* find_function(std::string_view name) {
    const auto* found = std::find_if(table.begin(), table.end(),
                                     [&](const Function& entry) { return entry.name == name; });
    return found == table.end() ? nullptr : found;
}

}  // namespace hvi::gen
