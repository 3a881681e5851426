// Products that others have as a part.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Returns the values, with products taken apart and put together so that what several of them have
/// in common is computed once: x y^2 and y x^2 as s y and s x with s = x y. Returns the values
/// themselves where that takes as many operations, or more of them for each p or direction. NOTE:
/// the pair of factors that most products have is taken out, again and again (Breuer, Generation of
/// optimal code for expressions via factorization, CACM 12 (1969) 333).
[[nodiscard]] std::vector<Scaled> with_common_products(Graph& graph,
                                                       const std::vector<Scaled>& values);

}  // namespace hvi::gen
