// The Taylor series in h of the exact discrete Hamiltonian and of a method's, for any H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/expr/expression.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// The series of H_d^+ - q_0 p_1 in powers of h. Its coefficients are functions of q_0 and p_1,
/// which have the names of H's variables; the time in them is the time at the beginning of the
/// step.
struct DiscreteSeries {
    /// A coefficient; empty where it is too long to be computed.
    using Coefficient = std::optional<Expression>;

    std::vector<Coefficient> exact;   ///< coefficients of h, h^2, ... in (4.1)
    std::vector<Coefficient> method;  ///< the coefficients in (4.19), or (4.6)
    /// The first power at which the series provably differ, while they provably agree below; empty
    /// where all agree. For a method of order r it is r + 1 or, for some H, more.
    std::optional<int> first_difference;
    Coefficient difference;  ///< method's coefficient less the exact one at that power
    /// The power at which neither could be proved; then higher powers are not known either.
    std::optional<int> undecided;
};

/// Returns the series up to h^terms. Throws MathError where coefficients of the method have no
/// closed form or take too long; InputError as lower() does. Preconditions: the method is on the
/// field of `ground`, for the general Galerkin form d2H/dp2 is not known to be singular, and 1 <=
/// terms.
[[nodiscard]] DiscreteSeries discrete_series(const DerivedMethod& method,
                                             const Hamiltonian& hamiltonian, int terms,
                                             const Ground& ground);

}  // namespace hvi::gen
