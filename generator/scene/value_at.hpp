// Values of expressions where their symbols have values.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "generator/exact/numbers/ball.hpp"
#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// What symbols stand for.
using SymbolValues = std::map<std::string, Ball>;

/// An enclosure of the value, computed with some 80 digits; not finite where that does not tell
/// whether there is one. Throws MathError, with its place in `source` if that is not null, where
/// there provably is none among the real numbers: a division by zero, a root of a negative number,
/// ... A function of the user's own may be
/// any number. Preconditions: every symbol but pi and e has a value; neither roots nor bspline is
/// called.
[[nodiscard]] Ball value_at(const Expression& expression, const SymbolValues& symbols,
                            const std::shared_ptr<const Source>& source);

}  // namespace hvi::gen
