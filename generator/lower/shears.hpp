// Linear maps of a plane as products of shears, as nodes of a graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Changes of x and y under a map of their plane.
struct PlaneChange {
    Scaled x, y;
};

/// The shears x += first y, y += middle x, x += last y after a change of both signs, or of none.
struct Shears {
    Scaled first, middle, last;
    Scaled sign;  ///< 1, or a value that is 1 or -1
};

/// TurnAngles of rotations: any, or small ones, for which no sign changes. An angle that varies is
/// small up to 1, one that h and parameters decide up to a quarter turn.
struct TurnAngles {
    bool are_small = false;               ///< whether each is taken for small
    std::vector<Scaled> conditions = {};  ///< they are small where these are not negative
};

[[nodiscard]] PlaneChange sheared(Graph& graph, const Scaled& x, const Scaled& y,
                                  const Shears& shears);

/// Returns the rotation x' = x cos + y sin, y' = y cos - x sin by an angle, of which the half is
/// given. The shears are tan(r/2) and -sin(r) for the angle r in [-pi/2, pi/2] that is left after
/// half a turn, which is the sign.
[[nodiscard]] Shears rotation(Graph& graph, TurnAngles& angles, const Scaled& half_angle);

/// A quadratic form (a q^2 + 2 c q p + b p^2)/2.
struct PlaneForm {
    Scaled a, b, c;
};

/// Returns the flow of the form over a time, of which the half is given, as shears of x = p and y =
/// q. It turns where a b - c^2 is positive, and is hyperbolic where that is negative. Precondition:
/// b is not zero.
///
/// NOTE: two shears more, to p + (c/b) q and back, are no product of shears in the changes of a
/// step, as their roundings differ, and the energy drifts: 1e-18 of it a step.
[[nodiscard]] Shears oscillation(Graph& graph, TurnAngles& angles, const PlaneForm& form,
                                 const Scaled& half_time);

}  // namespace hvi::gen
