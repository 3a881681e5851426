// From a tableau to a scheme: what is solved for, what is evaluated, what is left out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/composition.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/plan/scheme.hpp"

namespace hvi::gen {

struct PlanOptions {
    bool separable = false;                       ///< for H = T(p) + U(q) only
    bool depends_on_time = false;                 ///< H = H(q, p, t); if it is separable U(q, t)
    bool kinetic_is_quadratic = false;            ///< and T = p^T K p/2 with constant K
    bool is_quadratic = false;                    ///< all steps are one linear map
    bool is_degenerate = false;                   ///< a row of d2H/dp2 is zero
    bool joint_gradient_pays = false;             ///< dH/dq and dH/dp at once, for coupled stages
    std::size_t degrees_of_freedom = 0;           ///< of a scene
    bool has_curve = false;                       ///< the stages of a step are asked for
    Solver solver = Solver::of_user;              ///< what is wished for
    Lanes lanes = Lanes::none;                    ///< the same
    std::optional<Composition> composition = {};  ///< a step is made of several of the method
    std::optional<Place> method = {};             ///< where it was given, for errors
};

/// Throws InputError when the tableau has free parameters in places that parametric() refuses.
/// Precondition: a composed method has none.
[[nodiscard]] Scheme plan(const Tableau& tableau, const PlanOptions& options);

}  // namespace hvi::gen
