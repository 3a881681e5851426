// Directions that a motion carries along: the derivative of its flow, and what they grow by.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "generator/drive/event_crossing.hpp"

namespace hvi::gen {

/// Measurements on directions.
struct TangentWishes {
    double h = 0;
    std::int64_t steps = 0;
    double rest = 0;             ///< the size of a shorter step behind them; 0 where there is none
    bool matrix = false;         ///< the derivative of the state at the end by that at the start
    bool largest = false;        ///< the largest Lyapunov exponent, and MEGNO
    bool spectrum = false;       ///< all Lyapunov exponents
    bool sali = false;           ///< the smaller alignment index
    bool own = false;            ///< the direction that begins as the states of the problem do
    DirectionVector start = {};  ///< of that, where states have no direction
    double t = 0;                ///< at the end
    FindMotion motion = {};      ///< of scaled time; nothing where time is not scaled
    FindCrossing crossing = {};  ///< of the event there, for its derivative beside the matrix

    [[nodiscard]] bool any() const { return matrix || largest || spectrum || sali || own; }
};

/// The growth of the direction that --lyapunov and --megno take.
struct LargestGrowth {
    Status status;  ///< unless it is ok, a step failed, and there are no numbers
    double lyapunov = 0, megno = 0;
};

/// Returns that direction, of norm 1. No component is small, so that it contains each mode.
[[nodiscard]] std::vector<double> growing_direction(std::size_t numbers);

/// Measures the growth over the steps of DrivenProblem, and calls see(taken) after each.
[[nodiscard]] LargestGrowth largest_growth(const TangentWishes& wishes,
                                           const std::function<void(std::int64_t)>& see);

/// Takes the steps of DrivenProblem, which carry directions along or whose states are those of
/// with_tangent(), and says what was measured. Of scaled time directions are those at one time.
/// Norms are of numbers as they stand in q and p, whatever their units. The status of its end is 0
/// also where a step failed.
[[nodiscard]] int take_tangents(const TangentWishes& wishes);

}  // namespace hvi::gen
