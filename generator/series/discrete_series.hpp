// The Taylor series in h of the exact discrete Hamiltonian and of that of a method, for any H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/expr/expression.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// H_d^+ - q_0 p_1 by powers of h, as functions of q_0 and p_1, which are called as the variables
/// of H are; the time in them is that at the beginning of the step.
struct DiscreteSeries {
    /// A coefficient; empty where it is too long to be computed.
    using Coefficient = std::optional<Expression>;

    std::vector<Coefficient> exact;   ///< of (4.1): of h, h^2, ...
    std::vector<Coefficient> method;  ///< of (4.19), or (4.6)
    /// The first power where they differ, which is proved, as it is that they agree below; empty
    /// where all agree. For a method of order r it is r + 1 or, for some H, more.
    std::optional<int> first_difference;
    Coefficient difference;  ///< there: that of the method less the exact one
    /// The power at which neither could be proved; then nothing is known of those beyond.
    std::optional<int> undecided;
};

/// Up to h^terms. Throws MathError where coefficients of the method have no closed form or take too
/// long; InputError as lower() does. Preconditions: the method is on the field of `ground`, for the
/// general Galerkin form d2H/dp2 is not known to be singular, and 1 <= terms.
[[nodiscard]] DiscreteSeries discrete_series(const DerivedMethod& method,
                                             const Hamiltonian& hamiltonian, int terms,
                                             const Ground& ground);

}  // namespace hvi::gen
