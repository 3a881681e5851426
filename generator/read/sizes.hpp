// Structural parameters: those in indices and ranges.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"
#include "generator/read/unroll.hpp"

namespace hvi::gen {

/// Returns the parameters of a scene that stand in an index or in a range, with those that their
/// values use. Throws InputError where one of them is no whole number.
[[nodiscard]] WholeNumbers sizes(const Scene& scene);

/// Returns the sizes in an expression and in names, with their values in `values`. Throws as above.
[[nodiscard]] WholeNumbers sizes(const IndexedExpression& expression,
                                 const std::vector<NameTexts>& names,
                                 const std::vector<Parameter>& values);

}  // namespace hvi::gen
