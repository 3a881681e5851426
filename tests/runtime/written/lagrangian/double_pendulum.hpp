// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:3 two-pendulums --energy --float128 --dense --name LagrangianDoublePendulum
// SPDX-License-Identifier: MIT
//
// gauss:3: symplectic, 3 stages, for Lagrangians.
// Basis functions of tau: 1, tau, tau^2.
// A == A~: a Runge-Kutta method, which conserves all quadratic invariants.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2-sqrt(15)/10
//     c_2 = 1/2
//     c_3 = 1/2+sqrt(15)/10
//     b_1 = 5/18
//     b_2 = 4/9
//     b_3 = 5/18
//     a_1,1 = 5/36
//     a_1,2 = 2/9-sqrt(15)/15
//     a_1,3 = 5/36-sqrt(15)/30
//     a_2,1 = 5/36+sqrt(15)/24
//     a_2,2 = 2/9
//     a_2,3 = 5/36-sqrt(15)/24
//     a_3,1 = 5/36+sqrt(15)/30
//     a_3,2 = 2/9+sqrt(15)/15
//     a_3,3 = 5/36
//     a~_i,j = a_i,j
//
// Found in L:
//
//     L is quadratic in v, and the mass matrix d2L/dv2 is not constant
//     16 of 16 second derivatives are not zero, 2 constant
//
// Cost:
//
//     6 unknowns are solved for in a step
//     dL/dq and dL/dv once: 5 additions, 10 multiplications, 4 calls
//     second derivatives once, where Newton's method is needed: 5 additions, 9 multiplications, 5
//         calls
//     evaluations in a step of one iteration: 3 of dL/dq, 3 of dL/dv
//
// Choices:
//
//     the velocities of the curve are solved for: (4.14) has p = dL/dv on it, and no mass matrix is
//         inverted in a formula
//     the basis is orthogonal for the rule: any basis of the span makes the same step, and with
//         this one an iteration needs no matrix larger than d2L/dv2
//     the last step's curve, extrapolated, gives the starting values of the iteration: they are
//         good to the order of the interpolation
//     fixed points, and Newton's method for steps on which they are slow: how stiff H is depends on
//         h and on the state
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/detail/coefficients/curve_coefficients.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/solvers/automatic.hpp>
#include <hvi/detail/solvers/newton_curves.hpp>
#include <hvi/detail/stages/curve.hpp>
#include <hvi/detail/stages/lagrangian_stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene two-pendulums with gauss:3, computed in Number: float, double, long double, or
/// hvi::math::Widest, which is __float128 where libm has functions of it, else long double. States
/// hold Numbers: arrays, or vectors of Eigen of fixed size.
/// The double pendulum, by its Lagrangian
template <class Number, class Numbers = std::array<Number, 2>>
class BasicLagrangianDoublePendulum {
    static_assert(hvi::math::computes_in<Number>,
                  "hvi: a scene is computed in float, double, long double or hvi::math::Widest");
    static_assert(hvi::detail::is_fixed_vector<Numbers, Number, 2>(),
                  "hvi: vectors are of these numbers, and of fixed size: std::array, or Eigen's");

public:
    using Scalar = Number;
    using Vector = Numbers;

    /// As the scene has them.
    struct Parameters {
        Scalar m1 = Scalar(1.0);  // m1 = 1
        Scalar m2 = Scalar(1.0);  // m2 = 1
        Scalar l1 = Scalar(1.0);  // l1 = 1
        Scalar l2 = Scalar(1.0);  // l2 = 1
        Scalar g = hvi::detail::rounded<Scalar>(9.81f, 9.81, -0x1.1e8p-51, -0x1.1eb851eb851ebp-51,
            -0x1.08p-104);  // g = 981/100
    };

    /// L =
    /// (m1+m2)*l1^2*v1^2/2+m2*l2^2*v2^2/2+m2*l1*l2*v1*v2*cos(theta1-theta2)+(m1+m2)*g*l1
    /// *cos(theta1)+m2*g*l2*cos(theta2), where q is (theta1, theta2) and v is (v1, v2).
    struct System {
        using Vector = Numbers;

        constexpr explicit System(const Parameters& parameters) {
            const Scalar t1 = parameters.m1 + parameters.m2;
            c1_ = parameters.l1 * parameters.l1 * t1;
            c2_ = parameters.l2 * parameters.l2 * parameters.m2;
            c3_ = parameters.m2 * parameters.l1 * parameters.l2;
            c4_ = parameters.g * t1 * parameters.l1;
            c5_ = parameters.m2 * parameters.g * parameters.l2;
        }

        constexpr void gradient(const Vector& q, const Vector& v, Vector& dLdq, Vector& dLdv) const
            {
            const Scalar t1 = q[0] - q[1];
            const Scalar t2 = hvi::math::cos(t1) * c3_;
            const Scalar t3 = v[0] * v[1] * c3_ * hvi::math::sin(t1);
            dLdq[0] = -(c4_ * hvi::math::sin(q[0]) + t3);
            dLdq[1] = -(c5_ * hvi::math::sin(q[1]) - t3);
            dLdv[0] = v[1] * t2 + v[0] * c1_;
            dLdv[1] = v[0] * t2 + v[1] * c2_;
        }

        constexpr void dLdv(const Vector& q, const Vector& v, Vector& out) const {
            const Scalar t1 = hvi::math::cos(q[0] - q[1]) * c3_;
            out[0] = v[1] * t1 + v[0] * c1_;
            out[1] = v[0] * t1 + v[1] * c2_;
        }

        template <class Matrix>
        constexpr void d2Ldq2(const Vector& q, const Vector& v, Matrix& out) const {
            const Scalar t1 = hvi::math::cos(q[0] - q[1]) * c3_ * (v[0] * v[1]);
            out(0, 0) = -(t1 + hvi::math::cos(q[0]) * c4_);
            out(1, 0) = t1;
            out(1, 1) = -(t1 + hvi::math::cos(q[1]) * c5_);
            for (std::size_t i = 1; i < 2; ++i) {
                for (std::size_t j = 0; j < i; ++j) { out(j, i) = out(i, j); }
            }
        }

        template <class Matrix>
        constexpr void d2Ldqdv(const Vector& q, const Vector& v, Matrix& out) const {
            const Scalar t1 = c3_ * hvi::math::sin(q[0] - q[1]);
            const Scalar t2 = v[1] * t1;
            const Scalar t3 = v[0] * t1;
            out(0, 0) = -t2;
            out(0, 1) = -t3;
            out(1, 0) = t2;
            out(1, 1) = t3;
        }

        template <class Matrix>
        constexpr void d2Ldv2(const Vector& q, [[maybe_unused]] const Vector& v, Matrix& out) const
            {
            out(0, 0) = c1_;
            out(1, 0) = hvi::math::cos(q[0] - q[1]) * c3_;
            out(1, 1) = c2_;
            for (std::size_t i = 1; i < 2; ++i) {
                for (std::size_t j = 0; j < i; ++j) { out(j, i) = out(i, j); }
            }
        }

        [[nodiscard]] constexpr Scalar energy(const Vector& q, const Vector& v) const {
            const Scalar t1 = hvi::math::cos(q[0] - q[1]) * c3_;
            const Scalar t2 = Scalar(0.5) * (v[0] * v[0] * c1_) + Scalar(0.5) * (v[1] * v[1] * c2_)
                + v[0] * v[1] * t1 + hvi::math::cos(q[0]) * c4_ + hvi::math::cos(q[1]) * c5_;
            const Scalar t3 = t2 - v[0] * (v[1] * t1 + v[0] * c1_) - v[1] * (v[0] * t1
                + v[1] * c2_);
            return -t3;
        }

        static constexpr void begin([[maybe_unused]] const Parameters& parameters, Vector& q,
            Vector& v) {
            q[0] = k1;
            q[1] = k2;
            v[0] = Scalar(0.0);
            v[1] = Scalar(0.0);
        }

        static constexpr Scalar k1 = hvi::detail::rounded<Scalar>(1.0471976f, 1.0471975511965979,
            -0x1.ee8p-54, -0x1.ee6913347c2a6p-54, -0x1.4p-110);  // pi/3
        static constexpr Scalar k2 = hvi::detail::rounded<Scalar>(0.7853982f, 0.7853981633974483,
            0x1.1a8p-55, 0x1.1a62633145c06p-55, 0x1.cp-108);  // pi/4
        Scalar c1_ = 0;
        Scalar c2_ = 0;
        Scalar c3_ = 0;
        Scalar c4_ = 0;
        Scalar c5_ = 0;
    };

    using Solver = hvi::Automatic<hvi::NewtonOfLagrangians>;

    using State = hvi::State<Vector>;

    BasicLagrangianDoublePendulum() : BasicLagrangianDoublePendulum(Parameters{}) {}
    explicit BasicLagrangianDoublePendulum(const Parameters& parameters) : system_(parameters) {}

    /// Where the scene begins.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        Vector v{};
        System::begin(parameters, x.q, v);
        System(parameters).dLdv(x.q, v, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// v of p = dL/dv(q, v); no numbers where d2L/dv2 is singular.
    [[nodiscard]] Vector velocity(const State& x) const {
        return hvi::detail::velocity_of(system_, x.q, x.p);
    }

    /// v dL/dv - L
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, velocity(x));
    }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        s_.weigh(b);
        status = predict();
        if (!status.ok()) { return status; }

        status = solver_.solve(Coupled{system_, mass_, s_});
        if (!status.ok()) { return status; }

        s_.advance(B);
        return s_.end(x, status.iterations);
    }

    /// The position q_d(tau h) within the last step, on the curve of the method (Section 4.1 of the
    /// paper): where the step began at tau = 0, where it ended at 1. From the exact solution
    /// through its beginning it is O(h^4) away for all tau in [0, 1]. A step of size 0, or of one
    /// that is not finite, leaves the curve of the one before. After any other step that failed,
    /// after reset() and before any step the position is NaN.
    [[nodiscard]] Vector position(Scalar tau) const {
        if (!s_.has_ended()) { return hvi::detail::nowhere<Vector>(); }
        const auto bend = hvi::detail::departures(curve, tau);
        Vector q{};
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            const Scalar to_end = (1 - tau) * (B[0] * s_.W[0][k] + B[1] * s_.W[1][k]
                + B[2] * s_.W[2][k]);
            q[k] = s_.at.q[k] + (s_.remainder.q[k] + (-to_end + bend[0] * s_.W[0][k]
                + bend[1] * s_.W[1][k] + bend[2] * s_.W[2][k]));
        }
        return q;
    }

    /// The momentum at tau h within the last step: that at its beginning and the integral of dL/dq
    /// at the nodes, put together in the functions that the velocity of the curve is made of. From
    /// the exact solution it is O(h^4) away, as the position is; there is one where there is a
    /// position.
    [[nodiscard]] Vector momentum(Scalar tau) const {
        if (!s_.has_ended()) { return hvi::detail::nowhere<Vector>(); }
        const auto bend = hvi::detail::departures(curve_p, tau);
        Vector p{};
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            const Scalar to_end = (1 - tau) * (s_.Lp[0][k] + s_.Lp[1][k] + s_.Lp[2][k]);
            p[k] = s_.at.p[k] + (-to_end + bend[0] * s_.Lp[0][k] + bend[1] * s_.Lp[1][k]
                + bend[2] * s_.Lp[2][k]);
        }
        return p;
    }

    /// Forgets what the last step left: remainders of the sums, slopes, factors of Newton's method.
    void reset() { s_.forget(); }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    // rounded(...) is the number of its comment as float, double, long double or __float128: the
    // one that Scalar is.
    static constexpr auto& rounded = hvi::detail::rounded<Scalar>;

    static constexpr Scalar b[3] = {
        // b_1 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c7p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
        // b_2 = 4/9
        rounded(0.44444445f, 0.4444444444444444, 0x1.c7p-56, 0x1.c71c71c71c71cp-56, 0x1.cp-110),
        // b_3 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c7p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
    };

    // (4.14) in a basis phi that is orthogonal for the rule: X_ij = b_i phi_j(c_i), A_ij and B_j
    // are its integrals to c_i and to 1, and D_ij = B_j - A_ij, rounded so that this holds exactly,
    // and B_j is the sum of the X_ij.
    static constexpr Scalar X[3][3] = {
        {
            // X_1,1 = 5/18
            rounded(0.2777778f, 0.2777777777777778, -0x1.c8p-57, -0x1.c71c71c71c71cp-57,
                -0x1.cp-111),
            Scalar(0.0),  // X_1,2 = 0
            Scalar(0.0),  // X_1,3 = 0
        },
        {
            Scalar(0.0),  // X_2,1 = 0
            // X_2,2 = 4/9
            rounded(0.44444442f, 0.4444444444444444, 0x1.c7p-56, 0x1.c71c71c71c71cp-56, 0x1.cp-110),
            Scalar(0.0),  // X_2,3 = 0
        },
        {
            Scalar(0.0),  // X_3,1 = 0
            Scalar(0.0),  // X_3,2 = 0
            // X_3,3 = 5/18
            rounded(0.2777778f, 0.2777777777777778, -0x1.c8p-57, -0x1.c71c71c71c71cp-57,
                -0x1.cp-111),
        },
    };
    static constexpr Scalar A[3][3] = {
        {
            // A_1,1 = 5/36
            rounded(0.1388889f, 0.13888888888888884, 0x1.c7p-55, 0x1.c71c71c71c71cp-55, 0x1.cp-109),
            // A_1,2 = 2/9-sqrt(15)/15
            rounded(-0.03597665f, -0.03597666752493889, -0x1.2p-56, -0x1.1f9a1c81ea4bap-56,
                -0x1p-111),
            // A_1,3 = 5/36-sqrt(15)/30
            rounded(0.009789467f, 0.009789444015308346, -0x1.73p-56, -0x1.735b4724835ebp-56,
                -0x1.2p-110),
        },
        {
            // A_2,1 = 5/36+sqrt(15)/24
            rounded(0.30026317f, 0.3002631949808646, -0x1.18p-55, -0x1.17e6f3892de4cp-55,
                -0x1.e8p-108),
            // A_2,2 = 2/9
            rounded(0.22222221f, 0.2222222222222222, 0x1.c8p-57, 0x1.c71c71c71c71cp-57, 0x1.cp-111),
            // A_2,3 = 5/36-sqrt(15)/24
            rounded(-0.022485435f, -0.022485417203086833, 0x1.4cp-56, 0x1.4c3fae2ecd90bp-56,
                0x1.6p-109),
        },
        {
            // A_3,1 = 5/36+sqrt(15)/30
            rounded(0.26798832f, 0.26798833376246944, 0x1.2p-57, 0x1.1f9a1c81ea4bap-57, 0x1p-112),
            // A_3,2 = 2/9+sqrt(15)/15
            rounded(0.48042113f, 0.4804211119693833, 0x1.738p-55, 0x1.735b4724835ebp-55,
                0x1.2p-109),
            // A_3,3 = 5/36
            rounded(0.1388889f, 0.13888888888888884, 0x1.c7p-55, 0x1.c71c71c71c71cp-55, 0x1.cp-109),
        },
    };
    static constexpr Scalar D[3][3] = {
        {
            // D_1,1 = 5/36
            rounded(0.1388889f, 0.13888888888888895, -0x1.1c8p-54, -0x1.1c71c71c71c71p-54,
                -0x1.8cp-107),
            // D_1,2 = 2/9+sqrt(15)/15
            rounded(0.48042107f, 0.4804211119693833, 0x1.738p-55, 0x1.735b4724835ebp-55,
                0x1.2p-109),
            // D_1,3 = 5/36+sqrt(15)/30
            rounded(0.26798832f, 0.26798833376246944, 0x1.1ep-57, 0x1.1f9a1c81ea4bap-57, 0x1p-112),
        },
        {
            // D_2,1 = 5/36-sqrt(15)/24
            rounded(-0.022485375f, -0.022485417203086833, 0x1.4cp-56, 0x1.4c3fae2ecd90bp-56,
                0x1.6p-109),
            // D_2,2 = 2/9
            rounded(0.22222221f, 0.2222222222222222, 0x1.c6p-57, 0x1.c71c71c71c71cp-57, 0x1.cp-111),
            // D_2,3 = 5/36+sqrt(15)/24
            rounded(0.30026323f, 0.3002631949808646, -0x1.18p-55, -0x1.17e6f3892de4cp-55,
                -0x1.e8p-108),
        },
        {
            // D_3,1 = 5/36-sqrt(15)/30
            rounded(0.009789467f, 0.009789444015308346, -0x1.74p-56, -0x1.735b4724835ebp-56,
                -0x1.2p-110),
            // D_3,2 = 2/9-sqrt(15)/15
            rounded(-0.035976708f, -0.03597666752493889, -0x1.2p-56, -0x1.1f9a1c81ea4bap-56,
                -0x1p-111),
            // D_3,3 = 5/36
            rounded(0.1388889f, 0.13888888888888895, -0x1.1c8p-54, -0x1.1c71c71c71c71p-54,
                -0x1.8cp-107),
        },
    };
    static constexpr Scalar B[3] = {
        // B_1 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c8p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
        // B_2 = 4/9
        rounded(0.44444442f, 0.4444444444444444, 0x1.c7p-56, 0x1.c71c71c71c71cp-56, 0x1.cp-110),
        // B_3 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c8p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
    };
    static_assert(hvi::detail::symplectic_curve(X, A, D, B), "the method is symplectic");

    // q_d(tau h) is on the chord but for sum_k curve_ik g_k(tau) times slope i, with g_k(tau) =
    // (P_{k+1}-P_{k-1})(2*tau-1)/2 of Legendre's polynomials P_k.
    static constexpr Scalar curve[3][2] = {
        {
            // curve_1,1 = -sqrt(15)/18
            rounded(-0.21516573f, -0.21516574145596762, 0x1.fa8p-57, 0x1.fabcc7018c787p-57,
                0x1.cp-111),
            // curve_1,2 = 1/9
            rounded(0.11111111f, 0.1111111111111111, 0x1.c7p-58, 0x1.c71c71c71c71cp-58, 0x1.cp-112),
        },
        {
            Scalar(0.0),  // curve_2,1 = 0
            // curve_2,2 = -2/9
            rounded(-0.22222222f, -0.2222222222222222, -0x1.c7p-57, -0x1.c71c71c71c71cp-57,
                -0x1.cp-111),
        },
        {
            // curve_3,1 = sqrt(15)/18
            rounded(0.21516573f, 0.21516574145596762, -0x1.fa8p-57, -0x1.fabcc7018c787p-57,
                -0x1.cp-111),
            // curve_3,2 = 1/9
            rounded(0.11111111f, 0.1111111111111111, 0x1.c7p-58, 0x1.c71c71c71c71cp-58, 0x1.cp-112),
        },
    };
    // As much of p, times Lp_i.
    static constexpr Scalar curve_p[3][2] = {
        {
            // curve_p_1,1 = -sqrt(15)/5
            rounded(-0.7745967f, -0.7745966692414834, 0x1.f7p-56, 0x1.f686ffcf96727p-56, 0.0),
            // curve_p_1,2 = 2/5
            rounded(0.4f, 0.4, -0x1.998p-56, -0x1.9999999999999p-56, -0x1.3p-109),
        },
        {
            Scalar(0.0),   // curve_p_2,1 = 0
            Scalar(-0.5),  // curve_p_2,2 = -1/2
        },
        {
            // curve_p_3,1 = sqrt(15)/5
            rounded(0.7745967f, 0.7745966692414834, -0x1.f7p-56, -0x1.f686ffcf96727p-56, 0.0),
            // curve_p_3,2 = 2/5
            rounded(0.4f, 0.4, -0x1.998p-56, -0x1.9999999999999p-56, -0x1.3p-109),
        },
    };

    // G_j is the sum of b_i phi_j(c_i)^2 over i.
    static constexpr Scalar inverse_G[3] = {
        // 1/G_1 = 18/5
        rounded(3.6f, 3.6, -0x1.9ap-54, -0x1.9999999999999p-54, -0x1.3p-107),
        Scalar(2.25),  // 1/G_2 = 9/4
        // 1/G_3 = 18/5
        rounded(3.6f, 3.6, -0x1.9ap-54, -0x1.9999999999999p-54, -0x1.3p-107),
    };

    // W of the next step is about N_W times that of this one.
    static constexpr Scalar N_W[3][3] = {
        {
            Scalar(0.46034998712591646), Scalar(-1.5026888717234441),
            Scalar(2.0423388845975277),
        },
        {
            Scalar(2.0423388845975277), Scalar(-5.666666666666667), Scalar(4.624327782069139),
        },
        {
            Scalar(4.624327782069139), Scalar(-11.83064446160989), Scalar(8.20631667954075),
        },
    };

    /// Takes d2L/dv2 there for the iteration.
    [[nodiscard]] Status freeze(const Vector& q) {
        const auto fill = [&](auto& out) { system_.d2Ldv2(q, s_.at.p, out); };
        if (mass_.compute(fill)) { return {}; }
        return Status(mass_.is_finite() ? Status::Code::singular : Status::Code::not_finite);
    }

    /// Starting values: the curve of the last step goes on, else straight.
    [[nodiscard]] Status predict() {
        if (s_.goes_on) { s_.extrapolate(N_W); }
        if (!s_.goes_on) {
            const Status start = freeze(s_.at.q);
            if (!start.ok()) { return start; }
            const Vector v = hvi::detail::velocity_of(system_, mass_, s_.at.q, s_.at.p);
            s_.go_straight(v, B, inverse_G);
        }
        Coupled equations{system_, mass_, s_};
        equations.positions();
        const Status status = freeze(s_.Q[1]);
        if (status.ok()) { equations.slopes(); }
        return status;
    }

    /// The equations of the 3 W_j, which are solved at once.
    struct Coupled {
        const System& system;
        const hvi::detail::FrozenMatrix<Vector>& mass;
        hvi::detail::LagrangianStages<Vector, 3, 3>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::size_t nodes = 3;
        static constexpr std::size_t functions = 3;

        /// P_i = dL/dv and Lp_i = h b_i dL/dq, where the velocity is U.
        void slopes() {
            for (std::size_t i = 0; i < nodes; ++i) {
                const Vector U = s.velocity(i, X);
                Vector dLdq{}, dLdv{};
                system.gradient(s.Q[i], U, dLdq, dLdv);
                s.set_slopes(i, dLdq, dLdv);
            }
        }

        /// P_i, and W_j corrected.
        void momenta() {
            s.momenta();
            s.correct(X, D, inverse_G, mass);
        }

        /// Q_i = q + (e_q + sum_j A_ij W_j).
        void positions() { s.positions(A); }

        [[nodiscard]] Scalar size_q(Index k) const { return s.size_q(k); }
        [[nodiscard]] Scalar size_p(Index k) const { return s.size_p(k); }

        static constexpr const auto& table_X() { return X; }
        static constexpr const auto& table_A() { return A; }
        static constexpr const auto& table_D() { return D; }
        template <class Matrix>
        void second_derivatives(std::size_t i, Matrix& qq, Matrix& qv, Matrix& vv) const {
            const Vector U = s.velocity(i, X);
            system.d2Ldq2(s.Q[i], U, qq);
            system.d2Ldqdv(s.Q[i], U, qv);
            system.d2Ldv2(s.Q[i], U, vv);
        }
    };

    System system_;
    hvi::detail::LagrangianStages<Vector, 3, 3> s_;
    hvi::detail::FrozenMatrix<Vector> mass_;  // d2L/dv2 in the middle of the step
    typename Solver::template Iteration<Vector> solver_;
};

using LagrangianDoublePendulum = BasicLagrangianDoublePendulum<double>;

}  // namespace hvi::generated
