// The user's wishes for a stepper. generator/plan decides about them, with reasons.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/composition.hpp"
#include "generator/plan/plan.hpp"
#include "generator/read/unrolling.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// A choice of the user, and its place.
template <class Choice>
struct Wish {
    Choice choice{};
    std::optional<Place> place = {};
};

/// Wishes for a stepper. Each is an option of `hvi-gen stepper`, listed in
/// options/option_table.cpp. Some cannot be wished for without a scene, for a class of the user:
/// their options need a scene.
struct StepperWishes {
    bool separable = false;  ///< H = T(p) + U(q), for a class of the user
    Solver solver = Solver::automatic;
    Wish<int> sweeps = {};  ///< so many a step; 0: as many as the solver takes
    Wish<Lanes> lanes = {Lanes::automatic};
    Unroll unroll = Unroll::automatic;            ///< whether sums are written out
    bool energy = false;                          ///< the energy as a member
    bool invariants = false;                      ///< invariants as members
    bool evaluations = false;                     ///< a member that counts dH/dq
    bool float128 = false;                        ///< one of the types to compute in
    bool dense = false;                           ///< the curve of a step, as a member
    bool action = false;                          ///< H_d^+ and the action of the steps, as members
    bool tangent = false;                         ///< steps carry directions along
    Given class_name = nullptr;                   ///< by check_class_name(); else the method's
    std::optional<Composition> composition = {};  ///< a step is made of several of the method
    std::string note = {};                        ///< for those who read the header; or empty
};

}  // namespace hvi::gen
