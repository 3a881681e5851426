// Both slopes of a stage at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

namespace hvi::detail {

/// Whether stage equations have slopes(), which sets all Lq and Lp at the present stages, in place
/// of velocities(), which sets Lq, and forces(), which sets Lp.
template <class Coupled, class = void>
struct HasJointSlopes : std::false_type {};
template <class Coupled>
struct HasJointSlopes<Coupled, std::void_t<decltype(&Coupled::slopes)>> : std::true_type {};

/// Whether dH/dp reuses values of the positions from the dH/dq before it.
template <class Coupled, class = void>
struct HasSharedSlopes : std::false_type {};
template <class Coupled>
struct HasSharedSlopes<Coupled,
                       std::void_t<decltype(std::declval<Coupled&>().velocities_after_forces())>>
    : std::true_type {};

}  // namespace hvi::detail
