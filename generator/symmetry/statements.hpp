// Statements on which conserved quantities of a scene a method keeps, and why.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/verdict.hpp"
#include "generator/symmetry/kept_by_parts.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

/// Facts of a method that decide the statements. A composition has the facts of its method.
struct KeepingFacts {
    Verdict symplectic;
    Verdict common_weights;  ///< b == b~
    Verdict runge_kutta;     ///< A == A~
    bool is_general_form = false;
    std::optional<KeptByParts> parts = {};  ///< of the scene, where steps are flows of these
    std::string obstacle = {};              ///< why the method has no steps of this scene; or empty
};
[[nodiscard]] KeepingFacts keeping_facts(const DerivedMethod& method);

enum class Keeping {
    kept,            ///< by each step, up to rounding and the solver's tolerance
    not_in_general,  ///< no known property of the method would keep it
    measured,        ///< the momentum map of a symmetry that is not affine, or it is not seen
                     ///< whether flows of parts of H keep it: runs measure it
    not_conserved,   ///< the exact motion does not conserve it at all energies; it may at some
    unknown,         ///< whether the motion conserves it is not known
};

struct Statement {
    std::string name;
    Expression expression;  ///< in the scene's variables
    Keeping keeping = Keeping::unknown;
    std::string reason;
};

/// Returns statements on momentum maps, invariants, those of [symmetries] and the energy, in this
/// order:
///
/// - a momentum map p (C q + d) is kept, as the action is affine and the discrete curve
///   interpolates in a vector space (Leok & Zhang, Theorem 5.3 and Lemma 5.4); for a tableau it
///   follows from the coefficients;
/// - q^T C p and linear functions are kept by symplectic partitioned methods with b = b~, and every
///   quadratic function by those with A = A~ (Hairer, Lubich & Wanner, Geometric Numerical
///   Integration, Theorems IV.2.2 and IV.2.4);
/// - with p^T S p and q^T R q as well, all of these methods keep it where S H_q = 0 and R H_p = 0:
///   the sums over stages that change these terms have such factors;
/// - a polynomial in kept quantities is kept;
/// - flows of parts of H keep what has no bracket with any part;
/// - with rotations, momentum maps alone are kept: natural charts commute with rotations of space
///   and of the body (Lemma 5.5).
[[nodiscard]] std::vector<Statement> statements(const SceneSymmetries& found,
                                                const KeepingFacts& method);

}  // namespace hvi::gen
