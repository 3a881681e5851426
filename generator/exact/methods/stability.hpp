// Linear stability: the z = h omega for which a method's map of the harmonic oscillator is power
// bounded.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/exact/methods/oscillator.hpp"

namespace hvi::gen {

/// An interval of z, without its ends unless they are marked as included.
struct StabilityInterval {
    Number low, high;
    bool low_included = false;
    bool high_included = false;
};

/// A point where half the trace is 1 or -1, and its absolute value is less than 1 on either side.
struct TouchingPoint {
    Number z;
    int half_trace = 1;
    bool is_identity = false;  ///< the map is +-I, not a Jordan block
};

/// Limit of half the trace as z grows.
struct LimitOfHalfTrace {
    std::optional<Number> value;  ///< empty where it is infinite
    int sign = 0;                 ///< of the limit
    bool is_stable = false;       ///< whether all z from some point on are stable
};

/// Stable z of a map. Where the map has determinant 1 its powers are bounded where |half_trace| <
/// 1, and where it is I or -I. Where half_trace is 1 or -1 and the map is another matrix, a Jordan
/// block, they grow linearly: such a point of resonance splits an interval, and a touching point
/// with +-I does not. For a map with another determinant, z is stable where both eigenvalues lie
/// inside the unit circle, so that its powers tend to 0; it has no touching points.
struct LinearStability {
    long until = 0;
    std::vector<StabilityInterval> stable;  ///< in the open interval (0, until), ascending
    std::vector<Number> poles;              ///< z at which the map does not exist, ascending
    std::vector<TouchingPoint> touching;    ///< ascending
    LimitOfHalfTrace at_infinity;
    bool proved = false;  ///< whether no enclosure was taken for zero
};

/// Returns the stable z. Ends, poles and touching points have closed forms where `roots_in_square`
/// finds them, and are certified enclosures otherwise. Precondition: the map has no free parameter.
[[nodiscard]] LinearStability linear_stability(const OscillatorMap& map, long until);

}  // namespace hvi::gen
