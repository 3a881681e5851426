// Collocation at nodes that are known to some digits only.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/number_stages.hpp"

namespace hvi::gen {

/// Returns b_j, a_ij and a~_ij of collocation: the integrals of Lagrange's polynomials over [0,1]
/// and [0, c_i], and b_j - b_j a_ji/b_i. Each is enclosed by one ball, for all nodes that c can be.
/// Empty where two nodes may be equal or a weight zero.
[[nodiscard]] std::optional<PartitionedMethod> enclosed_collocation(const NumberVector& c,
                                                                    Precision bits);

/// Returns the partner a~_ij = b_j - b_j a_ji/b_i of any coefficients, so that the pair is
/// symplectic; as exact as they are. Empty where a weight may be zero.
[[nodiscard]] std::optional<NumberMatrix> symplectic_partner(const NumberVector& b,
                                                             const NumberMatrix& A, Precision bits);

}  // namespace hvi::gen
