// From an expression to a graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// What a symbol stands for.
using Symbols = std::map<std::string, Scaled>;

/// The expression in the graph. What depends on parameters alone is multiplied and added up apart
/// from the rest, so that it can be computed once for all steps; there is one division for all
/// denominators in a product that depend on variables. Preconditions: every symbol but pi and e is
/// one of `symbols`; neither roots nor bspline is called. Throws InputError, with its place in
/// `source`, for a division by what is seen to be zero.
[[nodiscard]] Scaled lower(Graph& graph, const Expression& expression, const Symbols& symbols,
                           const std::shared_ptr<const Source>& source);

}  // namespace hvi::gen
