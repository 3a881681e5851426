// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:3
// SPDX-License-Identifier: MIT
//
// gauss:3: symplectic, 3 stages, for general Hamiltonians.
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
// Choices:
//
//     the last step's slopes, extrapolated, are the starting values of the iteration: they are good
//         to the order of the interpolation and cost no evaluation
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <hvi/detail/stages/stages.hpp>
#include <hvi/detail/stepper.hpp>
#include <hvi/fixed_point.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// `System` names its `Vector`, std::array<double, n> or one of Eigen, also of float, long double
/// or __float128, and has const members dHdq(q, p, out) and dHdp(q, p, out).
/// `Solver` is hvi::FixedPoint, or hvi::Newton of <hvi/newton.hpp> for steps that are not small
/// against the fastest period.
template <class System, class Solver = hvi::FixedPoint>
class Gauss3 {
    static_assert(hvi::detail::check_system<System, false>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    explicit Gauss3(System system = System{})
        : system_(std::move(system)) {}

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        s_.weigh(b, b);
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, s_});
        if (!status.ok()) { return status; }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k] + s_.Lq[1][k] + s_.Lq[2][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k] + s_.Lp[1][k] + s_.Lp[2][k]);
        }
        return s_.end(x, status.iterations);
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

    // m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij.
    static constexpr Scalar m[3][3] = {
        {
            Scalar(0.5),  // m_1,1 = 1/2
            // m_1,2 = 1/2-3*sqrt(15)/20
            rounded(-0.08094752f, -0.08094750193111255, 0x1.78p-56, 0x1.78e53fdbb0d5dp-56,
                0x1p-110),
            // m_1,3 = 1/2-3*sqrt(15)/25
            rounded(0.03524202f, 0.03524199845511, -0x1.03p-55, -0x1.02d7800e8610dp-55,
                -0x1.dp-108),
        },
        {
            // m_2,1 = 1/2+3*sqrt(15)/20
            rounded(1.0809475f, 1.0809475019311126, -0x1.78p-56, -0x1.78e53fdbb0d5dp-56, -0x1p-110),
            Scalar(0.5),  // m_2,2 = 1/2
            // m_2,3 = 1/2-3*sqrt(15)/20
            rounded(-0.08094752f, -0.08094750193111255, 0x1.78p-56, 0x1.78e53fdbb0d5dp-56,
                0x1p-110),
        },
        {
            // m_3,1 = 1/2+3*sqrt(15)/25
            rounded(0.964758f, 0.96475800154489, 0x1.03p-55, 0x1.02d7800e8610dp-55, 0x1.dp-108),
            // m_3,2 = 1/2+3*sqrt(15)/20
            rounded(1.0809475f, 1.0809475019311126, -0x1.78p-56, -0x1.78e53fdbb0d5dp-56, -0x1p-110),
            Scalar(0.5),  // m_3,3 = 1/2
        },
    };
    static_assert(hvi::detail::complementary(m, m), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[3][3] = {
        {
            Scalar(0.46034998712591646), Scalar(-0.9391805448271526),
            Scalar(2.0423388845975277),
        },
        {
            Scalar(3.2677422153560443), Scalar(-5.666666666666667), Scalar(7.398924451310623),
        },
        {
            Scalar(4.624327782069139), Scalar(-7.39415278850618), Scalar(8.20631667954075),
        },
    };

    /// Starting values: the polynomial through the slopes of the last step, else slopes as at the
    /// start of this one.
    void predict() {
        if (s_.goes_on) {
            for (Index k = 0; k < s_.at.q.size(); ++k) {
                const Scalar Lq_1 = s_.Lq[0][k];
                const Scalar Lq_2 = s_.Lq[1][k];
                const Scalar Lq_3 = s_.Lq[2][k];
                const Scalar Lp_1 = s_.Lp[0][k];
                const Scalar Lp_2 = s_.Lp[1][k];
                const Scalar Lp_3 = s_.Lp[2][k];
                s_.Lq[0][k] = N[0][0] * Lq_1 + N[0][1] * Lq_2 + N[0][2] * Lq_3;
                s_.Lq[1][k] = N[1][0] * Lq_1 + N[1][1] * Lq_2 + N[1][2] * Lq_3;
                s_.Lq[2][k] = N[2][0] * Lq_1 + N[2][1] * Lq_2 + N[2][2] * Lq_3;
                s_.Lp[0][k] = N[0][0] * Lp_1 + N[0][1] * Lp_2 + N[0][2] * Lp_3;
                s_.Lp[1][k] = N[1][0] * Lp_1 + N[1][1] * Lp_2 + N[1][2] * Lp_3;
                s_.Lp[2][k] = N[2][0] * Lp_1 + N[2][1] * Lp_2 + N[2][2] * Lp_3;
            }
            return;
        }
        auto&& slope = hvi::detail::scratch(s_.slope);
        system_.dHdp(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lq[0][k] = s_.hb_q[0] * slope[k];
            s_.Lq[1][k] = s_.hb_q[1] * slope[k];
            s_.Lq[2][k] = s_.hb_q[2] * slope[k];
        }
        system_.dHdq(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.hb_p[0] * slope[k];
            s_.Lp[1][k] = -s_.hb_p[1] * slope[k];
            s_.Lp[2][k] = -s_.hb_p[2] * slope[k];
        }
    }

    /// The stage equations of Q_1, Q_2, Q_3, P_1, P_2, P_3, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::Stages<Vector, 3, 3>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 3> unknown_q{0, 1, 2};
        static constexpr std::array<std::size_t, 3> unknown_p{0, 1, 2};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_1 = hvi::detail::moved(p, e_p + (m[0][0] * s.Lp[0][k]
                    + m[0][1] * s.Lp[1][k] + m[0][2] * s.Lp[2][k]));
                const Scalar P_2 = hvi::detail::moved(p, e_p + (m[1][0] * s.Lp[0][k]
                    + m[1][1] * s.Lp[1][k] + m[1][2] * s.Lp[2][k]));
                const Scalar P_3 = hvi::detail::moved(p, e_p + (m[2][0] * s.Lp[0][k]
                    + m[2][1] * s.Lp[1][k] + m[2][2] * s.Lp[2][k]));
                s.change.p[k] = hvi::detail::abs(P_1 - s.P[0][k]) + hvi::detail::abs(P_2
                    - s.P[1][k]) + hvi::detail::abs(P_3 - s.P[2][k]);
                s.P[0][k] = P_1;
                s.P[1][k] = P_2;
                s.P[2][k] = P_3;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_1 = hvi::detail::moved(q, e_q + (m[0][0] * s.Lq[0][k]
                    + m[0][1] * s.Lq[1][k] + m[0][2] * s.Lq[2][k]));
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (m[1][0] * s.Lq[0][k]
                    + m[1][1] * s.Lq[1][k] + m[1][2] * s.Lq[2][k]));
                const Scalar Q_3 = hvi::detail::moved(q, e_q + (m[2][0] * s.Lq[0][k]
                    + m[2][1] * s.Lq[1][k] + m[2][2] * s.Lq[2][k]));
                s.change.q[k] = hvi::detail::abs(Q_1 - s.Q[0][k]) + hvi::detail::abs(Q_2
                    - s.Q[1][k]) + hvi::detail::abs(Q_3 - s.Q[2][k]);
                s.Q[0][k] = Q_1;
                s.Q[1][k] = Q_2;
                s.Q[2][k] = Q_3;
            }
        }

        /// Lq_j = h b_j dH/dp.
        void velocities() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdp(s.Q[0], s.P[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[0][k] = s.hb_q[0] * slope[k];
            }
            system.dHdp(s.Q[1], s.P[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[1][k] = s.hb_q[1] * slope[k];
            }
            system.dHdp(s.Q[2], s.P[2], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[2][k] = s.hb_q[2] * slope[k];
            }
        }

        /// Lp_i = -h b_i dH/dq.
        void forces() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.Q[0], s.P[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[0][k] = -s.hb_p[0] * slope[k];
            }
            system.dHdq(s.Q[1], s.P[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[1][k] = -s.hb_p[1] * slope[k];
            }
            system.dHdq(s.Q[2], s.P[2], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[2][k] = -s.hb_p[2] * slope[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[0][k])
                + hvi::detail::abs(s.Q[1][k]) + hvi::detail::abs(s.Q[2][k])
                + hvi::detail::abs(s.Lq[0][k]) + hvi::detail::abs(s.Lq[1][k])
                + hvi::detail::abs(s.Lq[2][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.P[1][k]) + hvi::detail::abs(s.P[2][k])
                + hvi::detail::abs(s.Lp[0][k]) + hvi::detail::abs(s.Lp[1][k])
                + hvi::detail::abs(s.Lp[2][k]);
        }
    };

    System system_;
    hvi::detail::Stages<Vector, 3, 3> s_;
    typename Solver::template Iteration<Vector> solver_;
};

}  // namespace hvi::generated
