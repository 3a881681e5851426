// Basis functions psi_1 .. psi_s, from the user's list and from families.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/functions/function.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

struct BasisFunction {
    Expression form;  ///< as the user wrote it
    ExactFunction function;
    Place place;
};

/// Returns the functions for a method with these nodes. Throws as evaluate_function does.
[[nodiscard]] std::vector<BasisFunction>
basis_functions(const List& list, const std::vector<Number>& nodes, const Ground& ground);

}  // namespace hvi::gen
