// A graph from an expression.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Values of symbols.
using Symbols = std::map<std::string, Scaled>;

/// Returns the expression in the graph. Values that depend on parameters alone are multiplied and
/// added up apart from the rest, so that they can be computed once for all steps. A product has one
/// division for all denominators that depend on variables. Preconditions: every symbol but pi and e
/// is one of `symbols`; neither roots nor bspline is called. Throws InputError, with its place in
/// `source`, for a division by a value that is seen to be zero.
[[nodiscard]] Scaled lower(Graph& graph, const Expression& expression, const Symbols& symbols,
                           const std::shared_ptr<const Source>& source);

}  // namespace hvi::gen
