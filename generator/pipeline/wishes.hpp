// What the user wants of a stepper. What becomes of it is decided in generator/plan, with reasons.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/composition.hpp"
#include "generator/plan/plan.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// A choice of the user, and where it stands.
template <class Choice>
struct Wish {
    Choice choice{};
    std::optional<Place> place = {};
};

/// Of the stepper of a method, for a class of the user.
struct MethodWishes {
    bool separable = false;                       ///< H = T(p) + U(q)
    std::optional<Composition> composition = {};  ///< a step is made of several of the method
    Given class_name = nullptr;                   ///< by check_class_name(); else the method's
};

/// Of the stepper of a scene.
struct StepperWishes {
    Solver solver = Solver::automatic;
    Wish<Lanes> lanes = {Lanes::automatic};
    bool energy = false;                          ///< as a member
    bool invariants = false;                      ///< the same
    bool evaluations = false;                     ///< of dH/dq, counted, the same
    bool float128 = false;                        ///< among the numbers that it computes in
    bool dense = false;                           ///< the curve of a step, the same
    Given class_name = nullptr;                   ///< the same, or from scene and method
    std::optional<Composition> composition = {};  ///< a step is made of several of the method
};

}  // namespace hvi::gen
