// The splitting of Wisdom & Holman by hand, in coordinates of Jacobi.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace bench {

/// Six bodies, as a good programmer would step them: half of the orbits, a kick, half of the
/// orbits. Coordinates are those of Jacobi all the time, and sums are plain. Orbits are ellipses,
/// by Gauss' f and g with the difference of eccentric anomalies (Danby, Fundamentals of Celestial
/// Mechanics, Section 6.8).
class OrbitsByHand {
public:
    static constexpr std::size_t bodies = 6;
    using Vector = std::array<double, 3>;
    using Vectors = std::array<Vector, bodies>;

    OrbitsByHand(double G, const std::array<double, bodies>& masses, const Vectors& positions,
                 const Vectors& velocities)
        : G_(G), masses_(masses) {
        Vector centre{}, drift{};
        double mass = 0;
        for (std::size_t j = 0; j < bodies; ++j) {
            for (std::size_t a = 0; a < 3; ++a) {
                Q_[j][a] = positions[j][a] - centre[a];
                V_[j][a] = velocities[j][a] - drift[a];
            }
            mass += masses[j];
            sums_[j] = mass;
            for (std::size_t a = 0; a < 3; ++a) {
                centre[a] += masses[j] / mass * Q_[j][a];
                drift[a] += masses[j] / mass * V_[j][a];
            }
        }
    }

    void step(double h) {
        for (std::size_t j = 1; j < bodies; ++j) move(j, h / 2);
        kick(h);
        for (std::size_t j = 1; j < bodies; ++j) move(j, h / 2);
    }

    /// Returns the place of body j from that of the first one.
    [[nodiscard]] Vector from_first(std::size_t j) const { return places()[j]; }

private:
    [[nodiscard]] static double dot(const Vector& a, const Vector& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    void move(std::size_t j, double h) {
        const double mu = G_ * sums_[j];
        Vector &q = Q_[j], &v = V_[j];
        const double r0 = std::sqrt(dot(q, q)), a = 1 / (2 / r0 - dot(v, v) / mu);
        const double n = std::sqrt(mu / (a * a * a));
        const double c = 1 - r0 / a, s = dot(q, v) / (n * a * a);
        double x = n * h, sine = 0, cosine = 1;
        for (int k = 0; k < 10; ++k) {
            sine = std::sin(x);
            cosine = std::cos(x);
            const double f = x - c * sine + s * (1 - cosine) - n * h;
            const double slope = 1 - c * cosine + s * sine;
            const double change = f / slope;
            x -= change;
            if (std::abs(change) < 1e-9) break;
        }
        sine = std::sin(x);
        cosine = std::cos(x);
        const double r = 1 - c * cosine + s * sine;
        const double f = 1 - a / r0 * (1 - cosine), g = h + (sine - x) / n;
        const double f_rate = -a / (r * r0) * n * sine, g_rate = 1 - (1 - cosine) / r;
        for (std::size_t k = 0; k < 3; ++k) {
            const double from = q[k];
            q[k] = f * from + g * v[k];
            v[k] = f_rate * from + g_rate * v[k];
        }
    }

    /// Returns the places from that of the first body.
    [[nodiscard]] Vectors places() const {
        Vectors x{};
        Vector centre{};
        for (std::size_t j = 1; j < bodies; ++j) {
            for (std::size_t a = 0; a < 3; ++a) {
                x[j][a] = Q_[j][a] + centre[a];
                centre[a] += masses_[j] / sums_[j] * Q_[j][a];
            }
        }
        return x;
    }

    void kick(double h) {
        const Vectors x = places();
        Vectors acceleration{};
        for (std::size_t i = 0; i < bodies; ++i) {
            for (std::size_t j = i + 1; j < bodies; ++j) {
                if (i == 0 && j == 1) continue;
                const Vector d{x[j][0] - x[i][0], x[j][1] - x[i][1], x[j][2] - x[i][2]};
                const double square = dot(d, d), factor = G_ / (square * std::sqrt(square));
                for (std::size_t a = 0; a < 3; ++a) {
                    acceleration[i][a] += masses_[j] * factor * d[a];
                    acceleration[j][a] -= masses_[i] * factor * d[a];
                }
            }
        }
        // Accelerations of Jacobi's coordinates are those of differences to centres of mass.
        Vector centre = acceleration[0];
        for (std::size_t j = 1; j < bodies; ++j) {
            const double square = dot(Q_[j], Q_[j]);
            const double back = j == 1 ? 0 : G_ * sums_[j] / (square * std::sqrt(square));
            for (std::size_t a = 0; a < 3; ++a) {
                const double relative = acceleration[j][a] - centre[a];
                V_[j][a] += h * (relative + back * Q_[j][a]);
                centre[a] += masses_[j] / sums_[j] * relative;
            }
        }
    }

    double G_;
    std::array<double, bodies> masses_, sums_{};
    Vectors Q_{}, V_{};
};

}  // namespace bench
