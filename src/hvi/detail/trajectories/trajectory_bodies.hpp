// Bodies that turn, of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/groups/chart_space.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi::detail {

/// Stands for the vectors of states in a `Space` with rotations, which `Stepper` knows as members
/// of a state. It is named before `Stepper` is complete.
template <class Space, class Stepper>
struct BodyVectors {};

template <class Space, class Stepper>
struct TrajectoryForm<BodyVectors<Space, Stepper>> {
    using Positions = typename Space::Positions;  ///< coordinates, then each R row by row
    using Momenta = typename Space::Vector;       ///< momenta, then each L in its body

    template <class One>
    [[nodiscard]] static ChartState<Space> flat(const One& x) {
        return Stepper::flat(x);
    }
    template <class One>
    static void set(One& x, const ChartState<Space>& at) {
        Stepper::set(x, at);
    }
};

}  // namespace hvi::detail
