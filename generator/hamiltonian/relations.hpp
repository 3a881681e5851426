// Linear relations among functions, with constant coefficients: all of them, where that is seen.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/hamiltonian/monomials.hpp"
#include "generator/hamiltonian/sparse_equations.hpp"
#include "generator/hamiltonian/vanishing.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

/// The vectors c with sum c_k f_k = 0, identically in the variables and the time.
struct Relations {
    /// Each is 1 where the others are 0, at the last of its own; what stands before is solved for.
    std::vector<SparseVector> basis;
    /// Empty where these are proved to be all; else why it is not known.
    std::string doubt;
};

/// Values of all functions at a point. Throws MathError where one has none.
using Sampler = std::function<std::vector<Ball>(const SymbolValues&)>;

/// What is found is exact: the coefficient of each monomial vanishes. That it is all is proved
/// where the monomials are linearly independent (is_independent()), else where values at points
/// have a matrix whose rank, by enclosures, leaves no room for more.
[[nodiscard]] Relations relations(Monomials& monomials, std::vector<MonomialSum> functions,
                                  const Sampler& sampler);

/// Whether an expression is zero for all values of its symbols: as vanishing(), and proved too
/// where all coefficients of its monomials vanish.
[[nodiscard]] Vanishing vanishing_by_monomials(const Algebra& algebra, const GiNaC::ex& expression);

/// Brings the powers of each sum that stands in denominators or under roots to one exponent in all
/// functions, and multiplies out what is above it. Whether that was possible for all.
[[nodiscard]] bool bring_to_common_powers(Monomials& monomials,
                                          std::vector<MonomialSum>& functions);

/// Whether the monomials of these functions are proved to be linearly independent over the numbers.
/// They are where all but polynomials are exponentials, sines and cosines of different polynomials,
/// and roots of polynomials that have no factor twice and none in common: continued around the
/// zeros of one of these, products of roots get different factors, and a relation among
/// exponentials exp(P) of algebraic functions, differentiated, would make some exp(P - Q)
/// algebraic. Precondition: bring_to_common_powers().
[[nodiscard]] bool is_independent(const Monomials& monomials,
                                  const std::vector<MonomialSum>& functions);

/// Whether enclosures of the functions at some points prove that so many of them are independent,
/// those with these numbers.
[[nodiscard]] bool are_independent_at_points(const Algebra& algebra, const Sampler& sampler,
                                             const std::vector<std::size_t>& numbers);

}  // namespace hvi::gen
