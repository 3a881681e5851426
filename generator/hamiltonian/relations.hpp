// Linear relations among functions, with constant coefficients. Finds all of them where that can be
// proved.
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

/// Vectors c with sum c_k f_k = 0, identically in the variables and the time.
struct Relations {
    /// The last entry of each vector is 1, and the other vectors are 0 there; earlier entries are
    /// solved for.
    std::vector<SparseVector> basis;
    /// Empty where these are proved to be all; else the reason why that is not known.
    std::string doubt;
};

/// Returns the values of all functions at a point. Throws MathError where one has none.
using Sampler = std::function<std::vector<Ball>(const SymbolValues&)>;

/// Finds exact relations: the coefficient of each monomial vanishes. They are proved to be all
/// where the monomials are linearly independent (is_independent()), else where enclosures of values
/// at points form a matrix whose rank leaves no room for more.
[[nodiscard]] Relations relations(Monomials& monomials, std::vector<MonomialSum> functions,
                                  const Sampler& sampler);

/// Whether an expression is zero for all values of its symbols. Decides as vanishing() does, and
/// proves it too where all coefficients of its monomials vanish.
[[nodiscard]] Vanishing vanishing_by_monomials(const Algebra& algebra, const GiNaC::ex& expression);

/// Brings the powers of each sum in denominators or under roots to one exponent in all functions,
/// and multiplies higher powers out. Returns whether that was possible for all functions.
[[nodiscard]] bool bring_to_common_powers(Monomials& monomials,
                                          std::vector<MonomialSum>& functions);

/// Whether the monomials of these functions are proved to be linearly independent over the numbers.
/// They are if all but polynomials are exponentials, sines and cosines of different polynomials,
/// and roots of polynomials without double and without common factors. Reasons: continued around
/// the zeros of one of these polynomials, products of roots get different factors. A relation among
/// exponentials exp(P) of algebraic functions, differentiated, would make some exp(P - Q)
/// algebraic. Precondition: bring_to_common_powers().
[[nodiscard]] bool is_independent(const Monomials& monomials,
                                  const std::vector<MonomialSum>& functions);

/// Whether enclosures at some points prove that the functions with these numbers are independent.
[[nodiscard]] bool are_independent_at_points(const Algebra& algebra, const Sampler& sampler,
                                             const std::vector<std::size_t>& numbers);

}  // namespace hvi::gen
