// Exponentials that are powers of others.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Returns the values with exp(k x) as the power of exp(x) where both are needed and k is a small
/// whole number: exp(-2 a r) and exp(-a r) of Morse's potential. NOTE: not 1/exp(x) for exp(-x),
/// whose digits are lost where exp(x) is nearly 0.
[[nodiscard]] std::vector<Scaled> with_powers_of_exponentials(Graph& graph,
                                                              const std::vector<Scaled>& values);

}  // namespace hvi::gen
