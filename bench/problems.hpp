// The systems that are timed.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include <hvi/state.hpp>

namespace bench {

/// H = p^2/2 - cos q.
struct Pendulum {
    using Vector = std::array<double, 1>;
    void dHdq(const Vector& q, Vector& out) const { out[0] = std::sin(q[0]); }
    void dHdp(const Vector& p, Vector& out) const { out[0] = p[0]; }
};

/// H = |p|^2/2 - 1/|q| in the plane.
struct Kepler {
    using Vector = std::array<double, 2>;
    void dHdq(const Vector& q, const Vector&, Vector& out) const {
        const double r2 = q[0] * q[0] + q[1] * q[1];
        const double scale = 1.0 / (r2 * std::sqrt(r2));
        out = {scale * q[0], scale * q[1]};
    }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
};

/// Kepler's problem for steppers that take H = T(p) + U(q).
struct SeparableKepler {
    using Vector = std::array<double, 2>;
    void dHdq(const Vector& q, Vector& out) const { Kepler{}.dHdq(q, q, out); }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
};

/// At the pericentre of an orbit of eccentricity 0.6 and period 2 pi.
inline hvi::State<std::array<double, 2>> pericentre() { return {{0.4, 0.0}, {0.0, 2.0}}; }

}  // namespace bench
