// Straight-line code in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/text/text.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

/// Names of nodes in C++.
using NodeNames = std::map<Node, std::string>;

/// Writes the statements that compute a kernel, `const Scalar t1 = ...;` for values that are used
/// more than once or are long, and returns an expression for each result. Functions are those of
/// <cmath>, in the namespace `library`. `value` is the type of the computed values; literals are
/// Scalars. Precondition: `names` has all that is given but numbers.
[[nodiscard]] std::vector<std::string> write_code(Writer& writer, const Graph& graph,
                                                  const Kernel& kernel, NodeNames names,
                                                  std::string_view library,
                                                  std::string_view value = "Scalar");

}  // namespace hvi::gen
