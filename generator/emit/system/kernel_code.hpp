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

/// What nodes are called in C++.
using NodeNames = std::map<Node, std::string>;

/// Writes the statements that compute a kernel, `const Scalar t1 = ...;` for what is used more than
/// once or long, and returns an expression for each result. Functions are those of <cmath>, in the
/// namespace `library`. `value`: the type of what is computed; literals are Scalars. Precondition:
/// `names` has all that is given but numbers.
[[nodiscard]] std::vector<std::string> write_code(Writer& writer, const Graph& graph,
                                                  const Kernel& kernel, NodeNames names,
                                                  std::string_view library,
                                                  std::string_view value = "Scalar");

}  // namespace hvi::gen
