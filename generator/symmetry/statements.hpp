// What a method keeps of what a scene conserves, and why.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/verdict.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

/// What of a method decides it. A composition has what its method has.
struct KeepingFacts {
    Verdict symplectic;
    Verdict common_weights;  ///< b == b~
    Verdict runge_kutta;     ///< A == A~
    bool is_general_form = false;
};
[[nodiscard]] KeepingFacts keeping_facts(const DerivedMethod& method);

enum class Keeping {
    kept,            ///< by each step, but for rounding and what the solver leaves
    not_in_general,  ///< nothing is known that would keep it
    measured,        ///< the momentum map of a symmetry that is not affine: see what a run says
    not_conserved,   ///< the exact motion does not at all energies; it may at some
    unknown,         ///< whether the motion does is not known
};

struct Statement {
    std::string name;
    Expression expression;  ///< in the scene's variables
    Keeping keeping = Keeping::unknown;
    std::string reason;
};

/// Of momentum maps, invariants, those of [symmetries] and the energy, in this order:
///
/// - a momentum map p (C q + d) is kept, as the action is affine and the discrete curve
/// interpolates
///   in a vector space (Leok & Zhang, Theorem 5.3 and Lemma 5.4); of a tableau by its coefficients;
/// - q^T C p and what is linear, by symplectic partitioned methods with b = b~, and every quadratic
///   function by those with A = A~ (Hairer, Lubich & Wanner, Geometric Numerical Integration,
///   Theorems IV.2.2 and IV.2.4);
/// - with p^T S p and q^T R q by all of them where S H_q = 0 and R H_p = 0: the sums over stages
///   that change these have such factors;
/// - a polynomial in what is kept;
/// - with rotations, momentum maps alone: natural charts commute with rotations of space and of the
///   body (Lemma 5.5).
[[nodiscard]] std::vector<Statement> statements(const SceneSymmetries& found,
                                                const KeepingFacts& method);

}  // namespace hvi::gen
