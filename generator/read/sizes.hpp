// Structural parameters: those that indices and ranges are made of.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"
#include "generator/read/unroll.hpp"

namespace hvi::gen {

/// The parameters of a scene that stand in an index or in a range, with those that their values are
/// made of. Throws InputError where one of them is no whole number.
[[nodiscard]] WholeNumbers sizes(const Scene& scene);

/// The same of an expression and of names, of which `values` are parameters.
[[nodiscard]] WholeNumbers sizes(const IndexedExpression& expression,
                                 const std::vector<NameTexts>& names,
                                 const std::vector<Parameter>& values);

}  // namespace hvi::gen
