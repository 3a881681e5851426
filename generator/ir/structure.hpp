// Structure of H or L, as its derivatives show it, and its second derivatives.
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

/// The second derivatives of an H or L without loops, by all its variables. Those by rotations are
/// by turns, and there the block qq is not symmetric.
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

/// The entries of one sum, within its loops; those below the diagonal too.
struct SumEntries {
    std::vector<Loop> loops;
    std::vector<std::size_t> accesses;
    std::vector<SumEntry> entries;
};

/// The second derivatives of an H whose sums stay loops.
struct HessianOfSums {
    std::vector<SumEntries> entries;  ///< of d2H/dq2, where HessianForm has these
    /// Sums whose derivatives `by_q` are, together, the product of the rows by q of d2H with a
    /// vector, and those by conjugates that of the other rows. The elements of the vector are
    /// accesses too: FamilyKind::direction and direction_of_conjugate.
    std::vector<SystemSum> products;
};

/// Second derivatives as steps take them; none of an H that is made of totals.
using SecondOrder = std::variant<std::monostate, Hessian, HessianOfSums>;

/// Whether H does not depend on some momentum, or not more than linearly: a row of d2H/dp2 is zero.
[[nodiscard]] bool is_degenerate(const Hessian& hessian);

// ---- what is found ----

/// A constant term of (d2H/dp2)_kk (d2H/dq2)_kk, as of a linear spring the square of a frequency.
struct LinearStiffness {
    std::size_t component;  ///< k
    Scaled value;
};

/// Terms of second derivatives that do not vary: of springs, or of a magnetic field. Those of
/// components that are coupled with no other, where T is quadratic, or of all; nothing where no
/// motion comes from them alone.
using ConstantTerms = std::variant<std::monostate, std::vector<LinearStiffness>, Hessian>;

/// Properties of H that its derivatives show; of an L nothing is looked for. True ones are proved:
/// a graph computes by exact algebra, and what it does not see to be constant may be proved so in a
/// field; see constant_value(). False ones may be true and hidden: exp(q) exp(-q) q + p. Values
/// and what is marked so are of an H without loops alone.
struct Structure {
    bool is_separable = false;          ///< H = T(p) + U(q), or T(p) + U(q, t)
    bool kinetic_is_quadratic = false;  ///< and T is quadratic, with a constant matrix d2H/dp2
    bool has_diagonal_mass = false;     ///< and that matrix is diagonal
    std::vector<Scaled> inverse_mass;   ///< then K p, for T = p^T K p/2 and what is linear in p
    std::vector<Node> direction;        ///< then inputs v_k of their own,
    std::vector<Scaled> qq_along;       ///< and d2H/dq2 v
    ConstantTerms constant;
    bool is_quadratic = false;                 ///< all second derivatives are constant
    bool has_linear_map = false;               ///< and H has no t: all steps are one linear map
    std::vector<Scaled> by_q, by_p;            ///< then the first derivatives at q = p = 0
    bool is_linear_in_p = false;               ///< without loops: d2H/dp2 is zero, and not all else
    bool is_linear_in_q = false;               ///< the same
    HessianForm hessian = HessianForm::dense;  ///< how Newton's method has d2H/dq2
};

/// Whether H has terms that are linear in q or p. Precondition: has_linear_map, without loops.
[[nodiscard]] bool has_linear_part(const Structure& quadratic);

}  // namespace hvi::gen
