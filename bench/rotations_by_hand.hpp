// Rigid bodies as one would write them by hand: split into turns about their axes, and in
// quaternions.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace bench {

/// The rotation from body to space, row by row, and the angular momentum in the body.
template <class Number>
struct Body {
    std::array<Number, 9> R;
    std::array<Number, 3> L;
};

/// Parameters of the scenes free-rigid-body and heavy-top.
template <class Number>
inline constexpr Number inertia[3] = {1, 2, 3};
template <class Number>
inline constexpr Number centre[3] = {Number(3) / 10, Number(1) / 10, 1};

template <bool is_heavy, class Number>
Number energy(const Body<Number>& x) {
    Number H = 0;
    for (std::size_t i = 0; i < 3; ++i) { H += x.L[i] * x.L[i] / (2 * inertia<Number>[i]); }
    for (std::size_t i = 0; i < 3 && is_heavy; ++i) { H += x.R[6 + i] * centre<Number>[i]; }
    return H;
}

/// R L, the angular momentum in space.
template <class Number>
std::array<Number, 3> spin(const Body<Number>& x) {
    std::array<Number, 3> J{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) { J[i] += x.R[3 * i + k] * x.L[k]; }
    }
    return J;
}

/// A splitting in steps of size 1: turns and kicks of the sizes first in one order, then of the
/// sizes second in the other, and so on.
using Splitting = std::vector<std::pair<double, double>>;

inline Splitting of_symmetric_steps(const std::vector<double>& sizes) {
    Splitting pairs;
    for (const double size : sizes) { pairs.emplace_back(size / 2, size / 2); }
    return pairs;
}

/// Suzuki's, of five steps.
inline Splitting suzuki_4() {
    const double w = 1 / (4 - std::cbrt(4.0));
    return of_symmetric_steps({w, w, 1 - 4 * w, w, w});
}

/// Blanes & Moan, J. Comput. Appl. Math. 142 (2002) 313, S of ten stages.
inline Splitting blanes_moan_6() {
    double half[10] = {0.050262764400392687, 0.098553683500650546, 0.31496061692769327,
                       -0.44734648269547692, 0.49242637248987498,  -0.42511876779769052,
                       0.23706391397812166,  0.19560248860005200,  0.34635818985072814};
    half[9] = 0.5;
    for (std::size_t i = 0; i < 9; ++i) { half[9] -= half[i]; }
    Splitting pairs;
    for (std::size_t i = 0; i < 10; i += 2) { pairs.emplace_back(half[i], half[i + 1]); }
    for (std::size_t i = 10; i > 0; i -= 2) { pairs.emplace_back(half[i - 1], half[i - 2]); }
    return pairs;
}

/// Kahan & Li, Math. Comp. 66 (1997) 1089, of 17 steps.
inline Splitting kahan_li_8() {
    std::vector<double> sizes = {0.13020248308889009, 0.56116298177510838,  -0.38947496264484729,
                                 0.15884190655515560, -0.39590389413323776, 0.18453964097831571,
                                 0.25837438768632204, 0.29501172360931031};
    double middle = 1;
    for (const double size : sizes) { middle -= 2 * size; }
    sizes.push_back(middle);
    for (std::size_t i = 8; i > 0; --i) { sizes.push_back(sizes[i - 1]); }
    return of_symmetric_steps(sizes);
}

/// A splitting of H = V(R) + L_1^2/2I_1 + L_2^2/2I_2 + L_3^2/2I_3, whose parts are solved exactly:
/// a kick, and turns about the axes of the body (McLachlan 1993, Reich 1994). Adjacent steps of one
/// part are joined, across steps too.
template <bool is_heavy>
class SplitBody {
public:
    SplitBody(const Body<double>& start, Splitting splitting)
        : x_(start), splitting_(std::move(splitting)) {}

    void advance(double h, long steps) {
        double pending = 0;
        for (long step = 0; step < steps; ++step) {
            for (const auto& [first, second] : splitting_) {
                const double a = h * first, b = h * second;
                outermost(pending + a);
                if constexpr (is_heavy) { turn<0>(a); }
                turn<1>(a);
                turn<2>(a + b);
                turn<1>(b);
                if constexpr (is_heavy) { turn<0>(b); }
                pending = b;
            }
        }
        outermost(pending);
    }

    [[nodiscard]] const Body<double>& body() const { return x_; }

    /// Turns and kicks; the last is that with which the next step begins.
    [[nodiscard]] long parts_of_step() const {
        return static_cast<long>(splitting_.size()) * (is_heavy ? 6 : 4);
    }

private:
    void outermost(double time) {
        if constexpr (is_heavy) {
            kick(time);
        } else {
            turn<0>(time);
        }
    }

    /// L' = -centre x R^T e_3.
    void kick(double time) {
        constexpr auto& c = centre<double>;
        const double* up = &x_.R[6];
        x_.L[0] -= time * (c[1] * up[2] - c[2] * up[1]);
        x_.L[1] -= time * (c[2] * up[0] - c[0] * up[2]);
        x_.L[2] -= time * (c[0] * up[1] - c[1] * up[0]);
    }

    template <std::size_t i>
    void turn(double time) {
        constexpr std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double angle = time * x_.L[i] * (1 / inertia<double>[i]);
        const double c = std::cos(angle), s = std::sin(angle);
        rotate(x_.L[j], x_.L[k], c, s);
        for (std::size_t row = 0; row < 9; row += 3) { rotate(x_.R[row + j], x_.R[row + k], c, s); }
    }
    static void rotate(double& a, double& b, double c, double s) {
        const double old = a;
        a = c * a + s * b;
        b = c * b - s * old;
    }

    Body<double> x_;
    Splitting splitting_;
};

/// A unit quaternion from body to space, its real part first, and the angular momentum in the body.
using Quaternion = std::array<double, 7>;

/// Precondition: R turns by less than pi.
inline Quaternion in_quaternions(const Body<double>& x) {
    const auto& R = x.R;
    const double w = std::sqrt(1 + R[0] + R[4] + R[8]) / 2;
    return {w,
            (R[7] - R[5]) / (4 * w),
            (R[2] - R[6]) / (4 * w),
            (R[3] - R[1]) / (4 * w),
            x.L[0],
            x.L[1],
            x.L[2]};
}

inline double length(const Quaternion& x) {
    return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
}

inline void normalise(Quaternion& x) {
    const double scale = 1 / length(x);
    for (std::size_t i = 0; i < 4; ++i) { x[i] *= scale; }
}

/// Returns the rotation of a quaternion, which need not be a unit quaternion.
inline Body<double> in_matrices(Quaternion x) {
    normalise(x);
    const double w = x[0], a = x[1], b = x[2], c = x[3];
    return {{1 - 2 * (b * b + c * c), 2 * (a * b - w * c), 2 * (a * c + w * b), 2 * (a * b + w * c),
             1 - 2 * (a * a + c * c), 2 * (b * c - w * a), 2 * (a * c - w * b), 2 * (b * c + w * a),
             1 - 2 * (a * a + b * b)},
            {x[4], x[5], x[6]}};
}

/// q' = q (0, omega)/2 and L' = L x omega - centre x R^T e_3.
template <bool is_heavy>
void right_side(const Quaternion& x, Quaternion& out) {
    constexpr auto& I = inertia<double>;
    const double w = x[0], a = x[1], b = x[2], c = x[3];
    const double u = x[4] * (1 / I[0]), v = x[5] * (1 / I[1]), z = x[6] * (1 / I[2]);
    out[0] = -0.5 * (a * u + b * v + c * z);
    out[1] = 0.5 * (w * u + b * z - c * v);
    out[2] = 0.5 * (w * v + c * u - a * z);
    out[3] = 0.5 * (w * z + a * v - b * u);
    out[4] = x[5] * z - x[6] * v;
    out[5] = x[6] * u - x[4] * z;
    out[6] = x[4] * v - x[5] * u;
    if constexpr (is_heavy) {
        constexpr auto& r = centre<double>;
        const double up[3] = {2 * (a * c - w * b), 2 * (b * c + w * a), 1 - 2 * (a * a + b * b)};
        out[4] -= r[1] * up[2] - r[2] * up[1];
        out[5] -= r[2] * up[0] - r[0] * up[2];
        out[6] -= r[0] * up[1] - r[1] * up[0];
    }
}

}  // namespace bench
