// Hamiltonian systems to run steppers on.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <Eigen/Dense>
#include <hvi/state.hpp>

namespace systems {

using One = std::array<double, 1>;
using Two = std::array<double, 2>;

/// Example 6.1: H = q p.
struct Dilation {
    using Vector = One;
    void dHdq(const Vector&, const Vector& p, Vector& out) const { out = p; }
    void dHdp(const Vector& q, const Vector&, Vector& out) const { out = q; }
};

/// Example 6.2: H = (p^2 + w^2 q^2)/2.
struct Oscillator {
    using Vector = One;
    double w = 1.0;
    void dHdq(const Vector& q, const Vector&, Vector& out) const { out[0] = w * w * q[0]; }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
    void d2Hdq2(const Vector&, const Vector&, Eigen::MatrixXd& out) const { out(0, 0) = w * w; }
    void d2Hdqdp(const Vector&, const Vector&, Eigen::MatrixXd&) const {}
    void d2Hdp2(const Vector&, const Vector&, Eigen::MatrixXd& out) const { out(0, 0) = 1.0; }
};

struct SeparableOscillator {
    using Vector = One;
    double w = 1.0;
    void dHdq(const Vector& q, Vector& out) const { out[0] = w * w * q[0]; }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
    void d2Hdq2(const Vector&, Eigen::MatrixXd& out) const { out(0, 0) = w * w; }
    void d2Hdp2(const Vector&, Eigen::MatrixXd& out) const { out(0, 0) = 1.0; }
};

/// H = (q^2 + 1)(p^2 + 1)/2, which no splitting separates.
struct Product {
    using Vector = One;
    void dHdq(const Vector& q, const Vector& p, Vector& out) const {
        out[0] = q[0] * (p[0] * p[0] + 1.0);
    }
    void dHdp(const Vector& q, const Vector& p, Vector& out) const {
        out[0] = p[0] * (q[0] * q[0] + 1.0);
    }
    void d2Hdq2(const Vector&, const Vector& p, Eigen::MatrixXd& out) const {
        out(0, 0) = p[0] * p[0] + 1.0;
    }
    void d2Hdqdp(const Vector& q, const Vector& p, Eigen::MatrixXd& out) const {
        out(0, 0) = 2.0 * q[0] * p[0];
    }
    void d2Hdp2(const Vector& q, const Vector&, Eigen::MatrixXd& out) const {
        out(0, 0) = q[0] * q[0] + 1.0;
    }
};

/// H = |p|^2/2 - 1/|q| in the plane, which counts how often it is asked.
struct Kepler {
    using Vector = Two;
    long* forces = nullptr;
    long* velocities = nullptr;
    void dHdq(const Vector& q, Vector& out) const {
        if (forces != nullptr) { ++*forces; }
        const double r2 = q[0] * q[0] + q[1] * q[1];
        const double r3 = r2 * std::sqrt(r2);
        out = {q[0] / r3, q[1] / r3};
    }
    void dHdp(const Vector& p, Vector& out) const {
        if (velocities != nullptr) { ++*velocities; }
        out = p;
    }
    void d2Hdq2(const Vector& q, Eigen::MatrixXd& out) const {
        const double r2 = q[0] * q[0] + q[1] * q[1];
        const double r5 = r2 * r2 * std::sqrt(r2);
        out(0, 0) = (r2 - 3 * q[0] * q[0]) / r5;
        out(1, 1) = (r2 - 3 * q[1] * q[1]) / r5;
        out(0, 1) = out(1, 0) = -3 * q[0] * q[1] / r5;
    }
    void d2Hdp2(const Vector&, Eigen::MatrixXd& out) const { out.setIdentity(); }
    static double energy(const hvi::State<Vector>& x) {
        return (x.p[0] * x.p[0] + x.p[1] * x.p[1]) / 2 - 1.0 / std::hypot(x.q[0], x.q[1]);
    }
};

/// A separable system for a stepper of general ones.
template <class Separable>
struct AsGeneral {
    using Vector = typename Separable::Vector;
    Separable system{};
    void dHdq(const Vector& q, const Vector&, Vector& out) const { system.dHdq(q, out); }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { system.dHdp(p, out); }
    void d2Hdq2(const Vector& q, const Vector&, Eigen::MatrixXd& out) const {
        system.d2Hdq2(q, out);
    }
    void d2Hdqdp(const Vector&, const Vector&, Eigen::MatrixXd&) const {}
    void d2Hdp2(const Vector&, const Vector& p, Eigen::MatrixXd& out) const {
        system.d2Hdp2(p, out);
    }
};

/// The gradient is not a number beyond |q| = limit.
struct Fenced {
    using Vector = One;
    double limit = 1.0;
    [[nodiscard]] double spoil(double q) const {
        return std::abs(q) > limit ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    }
    void dHdq(const Vector& q, Vector& out) const { out[0] = q[0] + spoil(q[0]); }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
};

/// Returns the units in the last place between two doubles of equal signs.
inline double ulps(double a, double b) {
    const double larger = std::fmax(std::abs(a), std::abs(b));
    if (a == b) { return 0.0; }
    return std::abs(a - b) /
           (std::nextafter(larger, std::numeric_limits<double>::infinity()) - larger);
}

template <class Vector>
bool same_bits(const Vector& a, const Vector& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

template <class Vector>
bool same_bits(const hvi::State<Vector>& a, const hvi::State<Vector>& b) {
    return same_bits(a.q, b.q) && same_bits(a.p, b.p);
}

}  // namespace systems
