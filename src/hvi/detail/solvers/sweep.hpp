// One sweep of a fixed-point iteration over stage equations.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/solvers/joint_slopes.hpp>

namespace hvi::detail {

/// The number of sweeps that counted ones are more of where no slopes can be extrapolated: in the
/// first two steps, and in the two after a change of the state or of h.
///
/// NOTE: in these steps K sweeps from the slopes at the start leave a larger error than in all
/// others together: of gauss:4 on Kepler's problem with h = 1/20 and two sweeps, 5e-7 of the energy
/// in two steps, and 3e-9 in the 4000 that follow.
inline constexpr int more_from_start = 16;

/// Sets the slopes at the last stages.
template <class Coupled>
[[gnu::always_inline]] inline void close(Coupled& coupled) {
    if constexpr (HasJointSlopes<Coupled>::value) {
        coupled.slopes();
    } else {
        coupled.forces();
    }
}

/// Moves the stages by the slopes: P from Lp, Lq from dHdp, Q from Lq. `is_first`: no forces have
/// been evaluated in this step.
template <bool is_first, class Coupled>
[[gnu::always_inline]] inline void sweep(Coupled& coupled) {
    coupled.momenta();
    if constexpr (HasSharedSlopes<Coupled>::value && !is_first) {
        coupled.velocities_after_forces();
    } else if constexpr (!HasJointSlopes<Coupled>::value) {
        coupled.velocities();
    }
    coupled.positions();
}

}  // namespace hvi::detail
