// Whether a stepper takes one trajectory or several.
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

namespace hvi::detail {

/// Whether a stepper takes several trajectories at once.
template <class Stepper, class = void>
struct TakesSeveral : std::false_type {};
template <class Stepper>
struct TakesSeveral<Stepper, std::void_t<typename Stepper::Trajectory>> : std::true_type {};

}  // namespace hvi::detail
