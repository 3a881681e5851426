// A real matrix in a basis in which it falls apart.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

/// Decomposition C = from D to, where `to` is the inverse of `from` and D has blocks alpha, one for
/// each real eigenvalue, and then (alpha beta; -beta alpha), one for each pair alpha +- i beta with
/// beta > 0. Both kinds ascend by alpha. All numbers are the doubles next to enclosures.
struct RealModes {
    std::size_t real_ones = 0;            ///< number of real eigenvalues
    std::vector<double> real_parts;       ///< of the blocks
    std::vector<double> imaginary_parts;  ///< of the pairs
    std::vector<std::vector<double>> to, from;
};

/// Returns the decomposition. Empty where the eigenvalues are not proved to be simple, and where a
/// number is no double. The eigenvalues are enclosed by Arb (Rump, Computational error bounds for
/// multiple or nearly multiple eigenvalues). Precondition: C is square and has no free parameters.
[[nodiscard]] std::optional<RealModes> real_modes(const NumberMatrix& C);

}  // namespace hvi::gen
