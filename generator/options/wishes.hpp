// What the user wants of a stepper. What becomes of it is decided in generator/plan, with reasons.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/composition.hpp"
#include "generator/plan/plan.hpp"
#include "generator/read/unrolling.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// A choice of the user, and where it stands.
template <class Choice>
struct Wish {
    Choice choice{};
    std::optional<Place> place = {};
};

/// Each is an option of `hvi-gen stepper`: options/option_table.cpp says of which. Where there is
/// no scene, but a class of the user, some cannot be wished for: their options need a scene.
struct StepperWishes {
    bool separable = false;  ///< H = T(p) + U(q), of a class of the user
    Solver solver = Solver::automatic;
    Wish<Lanes> lanes = {Lanes::automatic};
    Unroll unroll = Unroll::automatic;            ///< whether sums are written out
    bool energy = false;                          ///< as a member
    bool invariants = false;                      ///< the same
    bool evaluations = false;                     ///< of dH/dq, counted, the same
    bool float128 = false;                        ///< among the numbers that it computes in
    bool dense = false;                           ///< the curve of a step, as a member
    bool action = false;                          ///< H_d^+ and the action of the steps, the same
    bool tangent = false;                         ///< steps carry directions along
    Given class_name = nullptr;                   ///< by check_class_name(); else the method's
    std::optional<Composition> composition = {};  ///< a step is made of several of the method
    std::string note = {};                        ///< for those who read the header; or empty
};

}  // namespace hvi::gen
