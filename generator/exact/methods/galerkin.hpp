// Algorithm 4.3: from basis functions and quadrature nodes to the tableau.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// Computes the generalized Galerkin Hamiltonian SPRK method (Leok & Zhang, Section 4.4 and
/// Algorithm 4.3).
///
/// Throws MathError when there are fewer nodes than functions, when constants are not in the span
/// of the basis (Section 4.4.3), when M is singular, naming the combination of functions that
/// vanishes at all nodes, and when a weight is zero, naming the node. Throws InputError when there
/// are more nodes than functions: derive_any() computes that general form (4.6).
[[nodiscard]] Tableau derive(const Method& method);

/// A tableau on the field of `ground`, for callers that compute with the tableau and with numbers
/// of their own. Their numbers come from the ground in the result, which knows the values of the
/// method's parameters. derive_on() throws as derive() does, and TooCoarse (see on_new_ground).
struct Derivation {
    Tableau tableau;
    Ground ground;
};
[[nodiscard]] Derivation derive_on(const Ground& ground, const Method& method);

/// A tableau or the general form on the field of `ground`; see derive_any() and derive_on().
struct AnyDerivation {
    DerivedMethod method;
    Ground ground;
};
[[nodiscard]] AnyDerivation derive_any_on(const Ground& ground, const Method& method);

/// The two routes of steps 3 and 4: through M^-1, as `derive` goes, and by integrating the
/// functions phi = M^-1 psi themselves.
struct Weights {
    NumberVector b;
    NumberMatrix A;
};
struct Routes {
    Weights by_matrix;       ///< 3 (i), 4 (i)
    Weights by_integration;  ///< 3 (ii), 4 (ii)
};
[[nodiscard]] Routes both_routes(const Method& method);

}  // namespace hvi::gen
