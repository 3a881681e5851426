// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:2 --separable --name Gauss2Separable
// SPDX-License-Identifier: MIT
//
// gauss:2: symplectic, 2 stages, for separable Hamiltonians.
// Basis functions of tau: 1, tau.
// A == A~: a Runge-Kutta method, which conserves all quadratic invariants.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2-sqrt(3)/6
//     c_2 = 1/2+sqrt(3)/6
//     b_1 = 1/2
//     b_2 = 1/2
//     a_1,1 = 1/4
//     a_1,2 = 1/4-sqrt(3)/6
//     a_2,1 = 1/4+sqrt(3)/6
//     a_2,2 = 1/4
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

/// For H(q, p) = T(p) + U(q). `System` names its `Vector`, std::array<double, n> or one of Eigen,
/// also of float, long double or __float128, and has const members dHdq(q, out) = grad U and
/// dHdp(p, out) = grad T.
/// `Solver` is hvi::FixedPoint, or hvi::Newton of <hvi/newton.hpp> for steps that are not small
/// against the fastest period.
template <class System, class Solver = hvi::FixedPoint>
class Gauss2Separable {
    static_assert(hvi::detail::check_system<System, true>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    explicit Gauss2Separable(System system = System{})
        : system_(std::move(system)) {}

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, s_});
        if (!status.ok()) { return status; }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k] + s_.Lq[1][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k] + s_.Lp[1][k]);
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

    static constexpr Scalar b[2] = {
        Scalar(0.5),  // b_1 = 1/2
        Scalar(0.5),  // b_2 = 1/2
    };

    // m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij.
    static constexpr Scalar m[2][2] = {
        {
            Scalar(0.5),  // m_1,1 = 1/2
            // m_1,2 = 1/2-sqrt(3)/3
            rounded(-0.07735026f, -0.07735026918962573, -0x1.35p-55, -0x1.34863e0792becp-55,
                -0x1.3p-108),
        },
        {
            // m_2,1 = 1/2+sqrt(3)/3
            rounded(1.0773503f, 1.0773502691896257, 0x1.35p-55, 0x1.34863e0792becp-55, 0x1.3p-108),
            Scalar(0.5),  // m_2,2 = 1/2
        },
    };
    static_assert(hvi::detail::complementary(m, m), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[2][2] = {
        {
            Scalar(-0.7320508075688773), Scalar(1.7320508075688772),
        },
        {
            Scalar(-1.7320508075688772), Scalar(2.732050807568877),
        },
    };

    /// Starting values: the polynomial through the slopes of the last step, else slopes as at the
    /// start of this one.
    void predict() {
        if (s_.goes_on) {
            for (Index k = 0; k < s_.at.q.size(); ++k) {
                const Scalar Lp_1 = s_.Lp[0][k];
                const Scalar Lp_2 = s_.Lp[1][k];
                s_.Lp[0][k] = N[0][0] * Lp_1 + N[0][1] * Lp_2;
                s_.Lp[1][k] = N[1][0] * Lp_1 + N[1][1] * Lp_2;
            }
            return;
        }
        auto&& slope = hvi::detail::scratch(s_.slope);
        system_.dHdq(s_.at.q, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.h * b[0] * slope[k];
            s_.Lp[1][k] = -s_.h * b[1] * slope[k];
        }
    }

    /// The stage equations of Q_1, Q_2, P_1, P_2, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::Stages<Vector, 2, 2>& s;

        static constexpr bool separable = true;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 2> unknown_q{0, 1};
        static constexpr std::array<std::size_t, 2> unknown_p{0, 1};
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
                    + m[0][1] * s.Lp[1][k]));
                const Scalar P_2 = hvi::detail::moved(p, e_p + (m[1][0] * s.Lp[0][k]
                    + m[1][1] * s.Lp[1][k]));
                s.P[0][k] = P_1;
                s.P[1][k] = P_2;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_1 = hvi::detail::moved(q, e_q + (m[0][0] * s.Lq[0][k]
                    + m[0][1] * s.Lq[1][k]));
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (m[1][0] * s.Lq[0][k]
                    + m[1][1] * s.Lq[1][k]));
                s.change.q[k] = hvi::detail::abs(Q_1 - s.Q[0][k]) + hvi::detail::abs(Q_2
                    - s.Q[1][k]);
                s.Q[0][k] = Q_1;
                s.Q[1][k] = Q_2;
            }
        }

        /// Lq_j = h b_j dH/dp.
        void velocities() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdp(s.P[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[0][k] = s.h * b[0] * slope[k];
            }
            system.dHdp(s.P[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[1][k] = s.h * b[1] * slope[k];
            }
        }

        /// Lp_i = -h b_i dH/dq.
        void forces() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.Q[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[0][k] = -s.h * b[0] * slope[k];
            }
            system.dHdq(s.Q[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[1][k] = -s.h * b[1] * slope[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[0][k])
                + hvi::detail::abs(s.Q[1][k]) + hvi::detail::abs(s.Lq[0][k])
                + hvi::detail::abs(s.Lq[1][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.P[1][k]) + hvi::detail::abs(s.Lp[0][k])
                + hvi::detail::abs(s.Lp[1][k]);
        }
    };

    System system_;
    hvi::detail::Stages<Vector, 2, 2> s_;
    typename Solver::template Iteration<Vector> solver_;
};

}  // namespace hvi::generated
