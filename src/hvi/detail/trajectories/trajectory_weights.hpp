// The weights of steps of kicks and drifts, of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi::detail {

/// Weights of each lane; see MoveWeights.
template <class Scalar, std::size_t kicks, std::size_t drifts>
struct TrajectoryWeights {
    std::array<TrajectoryRow<Scalar>, kicks> p{};
    std::array<TrajectoryRow<Scalar>, drifts> q{};

    /// Sets those of a lane whose steps have the size h.
    void weigh(std::size_t lane, Scalar h, const Scalar (&b_p)[kicks],
               const Scalar (&b_q)[drifts]) {
        set(lane, weights_of_step(h, b_p), p);
        set(lane, weights_of_step(h, b_q), q);
    }

private:
    template <std::size_t count>
    static void set(std::size_t lane, const std::array<Scalar, count>& weights,
                    std::array<TrajectoryRow<Scalar>, count>& rows) {
        for (std::size_t i = 0; i < count; ++i) { rows[i].set(lane, weights[i]); }
    }
};

}  // namespace hvi::detail
