// Linear maps of a plane as products of shears, as nodes of a graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Changes of x and y under a map of their plane.
struct PlaneChange {
    Scaled x, y;
};

/// The three shears x += a y, y += b x, x += a y after a change of both signs, or of none.
struct Shears {
    Scaled a, b;
    Scaled sign;  ///< 1, or a value that is 1 or -1
};

[[nodiscard]] PlaneChange sheared(Graph& graph, const Scaled& x, const Scaled& y,
                                  const Shears& shears);

/// Returns the rotation x' = x cos + y sin, y' = y cos - x sin by an angle: a = tan(r/2), b =
/// -sin(r) for the angle r in [-pi/2, pi/2] that is left after half a turn, which is the sign.
[[nodiscard]] Shears rotation(Graph& graph, const Scaled& angle);

/// Returns the flow of (a q^2 + b p^2)/2 over a time, as shears of x = p and y = q: a rotation for
/// a b > 0, hyperbolic for a b < 0, and a shear for a b = 0.
[[nodiscard]] Shears oscillation(Graph& graph, const Scaled& a, const Scaled& b,
                                 const Scaled& time);

}  // namespace hvi::gen
