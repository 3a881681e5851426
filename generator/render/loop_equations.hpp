// Common parts of the formats of equations with indices.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/equations/loop_equations.hpp"

namespace hvi::gen {

/// The derivative by the elements of a family.
struct NamedSlope {
    const SystemFamily& family;
    const ElementSlope& slope;
};

/// Returns the derivatives that are not zero: by momenta, then by coordinates, in the order of the
/// equations of motion.
[[nodiscard]] std::vector<NamedSlope> named_slopes(const LoopEquations& step);

/// A term of a derivative. The terms that are everywhere come first. A sum that is not everywhere
/// is one term, in parentheses.
struct PlacedTerm {
    std::string text;
    std::vector<Loop> where;
};
[[nodiscard]] std::vector<PlacedTerm> placed_terms(const ElementSlope& slope, bool in_latex);

/// Returns `x[1..N]`, for each family.
[[nodiscard]] std::vector<std::string> texts(const std::vector<SystemFamily>& families);

/// Returns `k=2..N`, or `k=1`.
[[nodiscard]] std::string to_text(const Loop& range);

}  // namespace hvi::gen
