// Structure of H or L that its derivatives show, and its second derivatives.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "generator/ir/properties.hpp"
#include "generator/ir/sums.hpp"

namespace hvi::gen {

// ---- second derivatives ----

/// A block of a Hessian; a zero entry is proved to be one.
using HessianBlock = std::vector<std::vector<Scaled>>;

/// Second derivatives of an H or L without loops, by all its variables. Derivatives by rotations
/// are by turns, and there the block qq is not symmetric.
struct Hessian {
    HessianBlock qq;
    HessianBlock mixed;       ///< [i][j] by q_i and the conjugate of q_j
    HessianBlock conjugates;  ///< by p, or by v
};

/// An entry of d2H/dq2: a summand's second derivative by two of its elements.
struct SumEntry {
    std::size_t row = 0, column = 0;  ///< accesses
    Scaled value;
};

/// Entries of one sum, within its loops, also those below the diagonal.
struct SumEntries {
    std::vector<Loop> loops;
    std::vector<std::size_t> accesses;
    std::vector<SumEntry> entries;
};

/// Second derivatives of an H whose sums stay loops.
struct HessianOfSums {
    std::vector<SumEntries> entries;  ///< entries of d2H/dq2, where HessianForm needs them
    /// Sums for products of d2H with a vector. Their derivatives `by_q` add up to the rows by q of
    /// the product, and those by conjugates to the other rows. The elements of the vector are
    /// accesses too: FamilyKind::direction and direction_of_conjugate.
    std::vector<SystemSum> products;
};

/// Second derivatives for steps; none for an H that is made of totals.
using SecondOrder = std::variant<std::monostate, Hessian, HessianOfSums>;

/// Returns whether a row of d2H/dp2 is zero: H does not depend on some momentum, or only linearly.
[[nodiscard]] bool is_degenerate(const Hessian& hessian);

// ---- findings ----

/// A constant term of (d2H/dp2)_kk (d2H/dq2)_kk. For a linear spring it is the square of a
/// frequency.
struct LinearStiffness {
    std::size_t component;  ///< k
    Scaled value;
};

/// Constant terms of second derivatives, as of springs or a magnetic field: where T is quadratic,
/// those of components that are coupled with no other, otherwise all; none where they alone make no
/// motion.
using ConstantTerms = std::variant<std::monostate, std::vector<LinearStiffness>, Hessian>;

/// Properties of H that its derivatives show; for an L none is looked for. True ones are proved: a
/// graph computes by exact algebra, and a value that it does not see to be constant may be proved
/// so in a field; see constant_value(). False ones may be true and hidden: exp(q) exp(-q) q + p.
/// Nodes, and members marked so, exist only for an H without loops.
struct Structure {
    bool is_separable = false;          ///< H = T(p) + U(q), or T(p) + U(q, t)
    bool kinetic_is_quadratic = false;  ///< and T is quadratic, with a constant matrix d2H/dp2
    bool has_diagonal_mass = false;     ///< and that matrix is diagonal
    std::vector<Scaled> inverse_mass;   ///< then K p, for T = p^T K p/2 + terms linear in p
    std::vector<Node> direction;        ///< then inputs v_k for directions,
    std::vector<Scaled> qq_along;       ///< and d2H/dq2 v
    ConstantTerms constant;
    bool is_quadratic = false;       ///< all second derivatives are constant
    bool has_linear_map = false;     ///< and H does not depend on t: all steps are one linear map
    std::vector<Scaled> by_q, by_p;  ///< then the first derivatives at q = p = 0
    bool is_linear_in_p = false;     ///< without loops: d2H/dp2 is zero, and not all other blocks
    bool is_linear_in_q = false;     ///< without loops: d2H/dq2 is zero, and not all other blocks
    HessianForm hessian = HessianForm::dense;  ///< form of d2H/dq2 for Newton's method
};

/// Returns whether H has terms that are linear in q or p. Precondition: has_linear_map, without
/// loops.
[[nodiscard]] bool has_linear_part(const Structure& quadratic);

}  // namespace hvi::gen
