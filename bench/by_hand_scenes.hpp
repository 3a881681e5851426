// Loops as a specialist writes them for scenes: Störmer-Verlet, Gauss methods, a linear map.
// SPDX-License-Identifier: MIT
//
// A Problem has its dimension D, mass(k), and acceleration(q, a). All is in velocities, so that no
// mass is multiplied or divided by in a step. step() returns how often it iterated, or `failed`.
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>

#include <hvi/detail/coefficients/weights.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/state.hpp>

#include "nystroem.hpp"

namespace bench {

constexpr int failed = -1;

/// Masses of 1.
struct UnitMass {
    static constexpr double mass(std::size_t) { return 1.0; }
};

struct PendulumByHand : UnitMass {
    static constexpr std::size_t D = 1;
    static void acceleration(const double (&q)[1], double (&a)[1]) { a[0] = -std::sin(q[0]); }
};

struct HenonHeilesByHand : UnitMass {
    static constexpr std::size_t D = 2;
    static void acceleration(const double (&q)[2], double (&a)[2]) {
        a[0] = -q[0] - 2.0 * q[0] * q[1];
        a[1] = -q[1] - q[0] * q[0] + q[1] * q[1];
    }
};

struct KeplerByHand : UnitMass {
    static constexpr std::size_t D = 2;
    static void acceleration(const double (&q)[2], double (&a)[2]) {
        const double r2 = q[0] * q[0] + q[1] * q[1];
        const double scale = -1.0 / (r2 * std::sqrt(r2));
        a[0] = scale * q[0];
        a[1] = scale * q[1];
    }
};

/// Each pair once; q is (x_1 ... x_6, y_1 ... y_6, z_1 ... z_6).
struct SolarSystemByHand {
    static constexpr std::size_t bodies = 6;
    static constexpr std::size_t D = 3 * bodies;
    static constexpr double G = 2.95912208286e-4;
    static constexpr double m[bodies] = {1.00000597682,      0.000954786104043,  0.000285583733151,
                                         0.0000437273164546, 0.0000517759138449, 1 / 1.3e8};

    static constexpr double mass(std::size_t k) { return m[k % bodies]; }

    static void acceleration(const double (&q)[D], double (&a)[D]) {
        const double *x = q, *y = q + bodies, *z = q + 2 * bodies;
        double *ax = a, *ay = a + bodies, *az = a + 2 * bodies;
        for (double& component : a) { component = 0.0; }
        for (std::size_t i = 0; i < bodies; ++i) {
            for (std::size_t j = i + 1; j < bodies; ++j) {
                const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
                const double r2 = dx * dx + dy * dy + dz * dz;
                const double scale = G / (r2 * std::sqrt(r2));
                ax[i] += scale * m[j] * dx;
                ay[i] += scale * m[j] * dy;
                az[i] += scale * m[j] * dz;
                ax[j] -= scale * m[i] * dx;
                ay[j] -= scale * m[i] * dy;
                az[j] -= scale * m[i] * dz;
            }
        }
    }
};

/// Störmer-Verlet, the last acceleration kept.
template <class Problem>
class VerletByHand {
public:
    static constexpr std::size_t D = Problem::D;

    explicit VerletByHand(const hvi::State<std::array<double, D>>& x) {
        for (std::size_t k = 0; k < D; ++k) {
            q_[k] = x.q[k];
            v_[k] = x.p[k] / Problem::mass(k);
        }
        Problem::acceleration(q_, a_);
    }

    int step(double h) {
        for (std::size_t k = 0; k < D; ++k) {
            v_[k] += 0.5 * h * a_[k];
            q_[k] += h * v_[k];
        }
        Problem::acceleration(q_, a_);
        for (std::size_t k = 0; k < D; ++k) { v_[k] += 0.5 * h * a_[k]; }
        return 0;
    }

    [[nodiscard]] double q(std::size_t k) const { return q_[k]; }
    [[nodiscard]] double p(std::size_t k) const { return Problem::mass(k) * v_[k]; }

private:
    double q_[D], v_[D], a_[D];
};

/// Gauss with S stages: W_j = -h^2 b_j grad U(Q_j), where
///
///     Q_i = q + (e_q + (h c_i v + sum_j n_ij W_j)),
///
/// iterated down to round-off (see hvi::detail::RoundOff) from the W of the last step, of up to 3
/// stages of the last two, extrapolated; e are the remainders of compensated sums.
template <std::size_t S, class Problem>
class GaussByHand : private Nystroem<S> {
public:
    static constexpr std::size_t D = Problem::D;

    explicit GaussByHand(const hvi::State<std::array<double, D>>& x) {
        for (std::size_t k = 0; k < D; ++k) {
            q_[k] = x.q[k];
            v_[k] = x.p[k] / Problem::mass(k);
        }
    }

    int step(double h) {
        if (h != h_) { steps_behind_ = 0; }
        if (steps_behind_ >= (has_two_steps ? 2 : 1)) {
            extrapolate();
        } else {
            begin(h);
        }
        ++steps_behind_;
        const int iterations = iterate();
        if (iterations == failed) { return failed; }
        bool finite = true;
        for (std::size_t k = 0; k < D; ++k) {
            double drift = h * v_[k];
            double kick = 0.0;
            for (std::size_t j = 0; j < S; ++j) {
                drift += (1.0 - c[j]) * W_[j][k];
                kick += F_[j][k];
            }
            add(q_[k], e_q_[k], drift);
            add(v_[k], e_v_[k], kick);
            finite &= std::isfinite(q_[k]);
            finite &= std::isfinite(v_[k]);
        }
        return finite ? iterations : failed;
    }

    [[nodiscard]] double q(std::size_t k) const { return q_[k]; }
    [[nodiscard]] double p(std::size_t k) const { return Problem::mass(k) * v_[k]; }

private:
    using Nystroem<S>::b, Nystroem<S>::c, Nystroem<S>::n, Nystroem<S>::N;
    static constexpr int most_iterations = 200;
    static constexpr bool has_two_steps = S <= 5;

    /// Weights that add up to h, and accelerations as at the start.
    void begin(double h) {
        h_ = h;
        hb_ = hvi::detail::weights_of_step(h, b);
        if constexpr (has_two_steps) {
            for (std::size_t j = 0; j < S; ++j) { std::copy_n(W_[j], D, W_before_[j]); }
        }
        for (std::size_t j = 0; j < S; ++j) {
            for (std::size_t k = 0; k < D; ++k) { Q_[j][k] = q_[k]; }
        }
        accelerate();
    }

    void extrapolate() {
        for (std::size_t k = 0; k < D; ++k) {
            double next[S];
            for (std::size_t i = 0; i < S; ++i) {
                next[i] = 0.0;
                for (std::size_t j = 0; j < S; ++j) {
                    next[i] += N[i][j] * W_[j][k];
                    if constexpr (has_two_steps) {
                        next[i] += Nystroem<S>::N_before[i][j] * W_before_[j][k];
                    }
                }
            }
            for (std::size_t i = 0; i < S; ++i) {
                if constexpr (has_two_steps) { W_before_[i][k] = W_[i][k]; }
                W_[i][k] = next[i];
            }
        }
    }

    int iterate() {
        double smallest[D];
        double change[D];
        std::fill_n(smallest, D, DBL_MAX);
        int stalls = 0;
        move(change);
        for (int iteration = 2; iteration <= most_iterations; ++iteration) {
            accelerate();
            move(change);
            double total = 0.0;
            int falls = 0;
            for (std::size_t k = 0; k < D; ++k) {
                total += change[k];
                falls |=
                    static_cast<int>(change[k] > 0.0) & static_cast<int>(change[k] < smallest[k]);
                smallest[k] = change[k] < smallest[k] ? change[k] : smallest[k];
            }
            if (!(total <= DBL_MAX)) { return failed; }
            if (total == 0.0) { return iteration; }
            stalls = falls != 0 ? 0 : stalls + 1;
            if (stalls >= 2 && is_rounding(change)) {
                accelerate();
                return iteration;
            }
        }
        return failed;
    }

    /// F_j = -h b_j grad U(Q_j), W_j = h F_j.
    void accelerate() {
        for (std::size_t j = 0; j < S; ++j) {
            double a[D];
            Problem::acceleration(Q_[j], a);
            for (std::size_t k = 0; k < D; ++k) {
                F_[j][k] = hb_[j] * a[k];
                W_[j][k] = h_ * F_[j][k];
            }
        }
    }

    void move(double (&change)[D]) {
        for (std::size_t k = 0; k < D; ++k) {
            const double hv = h_ * v_[k];
            change[k] = 0.0;
            for (std::size_t i = 0; i < S; ++i) {
                double far = c[i] * hv;
                for (std::size_t j = 0; j < S; ++j) { far += n[i][j] * W_[j][k]; }
                const double Q = q_[k] + (e_q_[k] + far);
                change[k] += std::abs(Q - Q_[i][k]);
                Q_[i][k] = Q;
            }
        }
    }

    [[nodiscard]] bool is_rounding(const double (&change)[D]) const {
        bool all = true;
        for (std::size_t k = 0; k < D; ++k) {
            double size = 0.0;
            for (std::size_t i = 0; i < S; ++i) { size += std::abs(Q_[i][k]) + std::abs(W_[i][k]); }
            all &= change[k] <= 8 * DBL_EPSILON * size;
        }
        return all;
    }

    static void add(double& value, double& cut_off, double increment) {
        const hvi::Sum<double> sum = hvi::two_sum(value, cut_off + increment);
        value = sum.value;
        cut_off = sum.remainder;
    }

    double q_[D], v_[D], e_q_[D] = {}, e_v_[D] = {};
    double Q_[S][D] = {}, F_[S][D] = {}, W_[S][D] = {};
    double W_before_[S][D] = {};  // of the step before the last
    std::array<double, S> hb_{};
    double h_ = 0.0;
    int steps_behind_ = 0;  // of this size
};

/// Gauss with 4 stages for H = (p^2 + q^2)/2: a rotation by the angle of P(ih)/P(-ih), where P is
/// the numerator of the Padé approximant (4,4) of exp.
class RotationByHand {
public:
    explicit RotationByHand(const hvi::State<std::array<double, 1>>& x) : q_(x.q[0]), p_(x.p[0]) {}

    int step(double h) {
        if (h != h_) { begin(h); }
        const double q = cosine_ * q_ + sine_ * p_;
        p_ = cosine_ * p_ - sine_ * q_;
        q_ = q;
        return 0;
    }

    [[nodiscard]] double q(std::size_t) const { return q_; }
    [[nodiscard]] double p(std::size_t) const { return p_; }

private:
    /// Where P(ih) = x + iy.
    void begin(double h) {
        h_ = h;
        const double x = 1.0 - h * h * (3.0 / 28 - h * h / 1680);
        const double y = h * (0.5 - h * h / 84);
        cosine_ = (x * x - y * y) / (x * x + y * y);
        sine_ = 2.0 * x * y / (x * x + y * y);
    }

    double q_, p_;
    double cosine_ = 1.0, sine_ = 0.0, h_ = 0.0;
};

/// Gauss with 4 stages for a chain of four masses between walls: x' = R x for x = (q, p), where
/// R = P(hJ)/P(-hJ) with the matrix J of Hamilton's equations.
class ChainByHand {
public:
    explicit ChainByHand(const hvi::State<std::array<double, 4>>& x) {
        for (std::size_t k = 0; k < 4; ++k) {
            x_[k] = x.q[k];
            x_[4 + k] = x.p[k];
        }
    }

    int step(double h) {
        if (h != h_) { begin(h); }
        std::array<double, 8> next{};
        for (std::size_t j = 0; j < 8; ++j) {
            for (std::size_t i = 0; i < 8; ++i) { next[i] += columns_[j][i] * x_[j]; }
        }
        x_ = next;
        return 0;
    }

    [[nodiscard]] double q(std::size_t k) const { return x_[k]; }
    [[nodiscard]] double p(std::size_t k) const { return x_[4 + k]; }

private:
    using Matrix = std::array<std::array<double, 8>, 8>;

    static Matrix times(const Matrix& A, const Matrix& B) {
        Matrix product{};
        for (std::size_t i = 0; i < 8; ++i) {
            for (std::size_t j = 0; j < 8; ++j) {
                for (std::size_t k = 0; k < 8; ++k) { product[i][j] += A[i][k] * B[k][j]; }
            }
        }
        return product;
    }

    /// Solves A X = B by elimination; no pivots, since A is nearly 1.
    static Matrix solved(Matrix A, Matrix B) {
        for (std::size_t k = 0; k < 8; ++k) {
            for (std::size_t i = 0; i < 8; ++i) {
                const double factor = i == k ? 1.0 - 1.0 / A[k][k] : A[i][k] / A[k][k];
                const auto row = A[k], side = B[k];
                for (std::size_t j = 0; j < 8; ++j) {
                    A[i][j] -= factor * row[j];
                    B[i][j] -= factor * side[j];
                }
            }
        }
        return B;
    }

    void begin(double h) {
        h_ = h;
        Matrix z{}, numerator{}, denominator{}, power{};
        for (std::size_t k = 0; k < 4; ++k) {
            z[k][4 + k] = h;
            z[4 + k][k] = -2.0 * h;
            if (k > 0) { z[4 + k][k - 1] = z[4 + k - 1][k] = h; }
        }
        for (std::size_t k = 0; k < 8; ++k) { power[k][k] = 1.0; }
        for (const double c : {1.0, 1.0 / 2, 3.0 / 28, 1.0 / 84, 1.0 / 1680}) {
            for (std::size_t i = 0; i < 8; ++i) {
                for (std::size_t j = 0; j < 8; ++j) {
                    numerator[i][j] += c * power[i][j];
                    denominator[i][j] += (c == 1.0 / 2 || c == 1.0 / 84 ? -c : c) * power[i][j];
                }
            }
            power = times(power, z);
        }
        const Matrix R = solved(denominator, numerator);
        for (std::size_t i = 0; i < 8; ++i) {
            for (std::size_t j = 0; j < 8; ++j) { columns_[j][i] = R[i][j]; }
        }
    }

    std::array<double, 8> x_{};
    Matrix columns_{};
    double h_ = 0.0;
};

}  // namespace bench
