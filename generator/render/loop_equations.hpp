// Pieces that the formats of equations with indices have in common.
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

/// Derivatives that are not zero: by momenta, then by coordinates, as the equations of motion have
/// them.
[[nodiscard]] std::vector<NamedSlope> named_slopes(const LoopEquations& step);

/// A derivative's terms that are everywhere, and behind them the others; each of these is one, a
/// sum in parentheses.
struct PlacedTerm {
    std::string text;
    std::vector<Loop> where;
};
[[nodiscard]] std::vector<PlacedTerm> placed_terms(const ElementSlope& slope, bool in_latex);

/// `x[1..N]`, for each family.
[[nodiscard]] std::vector<std::string> texts(const std::vector<SystemFamily>& families);

/// `k=2..N`, or `k=1`.
[[nodiscard]] std::string to_text(const Loop& range);

}  // namespace hvi::gen
