// Values of expressions for values of their symbols.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "generator/exact/numbers/ball.hpp"
#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// The values of symbols.
using SymbolValues = std::map<std::string, Ball>;

/// Returns an enclosure of the value, computed with some 80 digits. It is not finite where it does
/// not tell whether there is a value. Throws MathError, with its place in `source` if that is not
/// null, where there provably is no real value: a division by zero, a root of a negative number,
/// ... A function of the user's own may be any number. Preconditions: every symbol but pi and e has
/// a value; neither roots nor bspline is called.
[[nodiscard]] Ball value_at(const Expression& expression, const SymbolValues& symbols,
                            const std::shared_ptr<const Source>& source);

}  // namespace hvi::gen
