// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:2 --hamiltonian "(p-a*sin(t))^2/2+q^4/4" --param "a=1/2" --solver newton --name ShakenNewton
// SPDX-License-Identifier: MIT
//
// gauss:2: symplectic, 2 stages, for general Hamiltonians.
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
// Found in H:
//
//     H is not seen to be T(p) + U(q)
//     H depends on the time
//     2 of 4 second derivatives are not zero, 1 constant
//
// Cost:
//
//     4 unknowns are solved for in a step
//     dH/dq once: 2 multiplications
//     dH/dp once: 1 addition, 1 multiplication, 1 call
//     second derivatives once, where Newton's method is needed: 2 multiplications
//     evaluations in a step of one iteration: 2 of dH/dq, 2 of dH/dp
//
// Choices:
//
//     the state has a time: H depends on it
//     the last step's slopes, extrapolated, are the starting values of the iteration: they are good
//         to the order of the interpolation and cost no evaluation
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/newton_pairs.hpp>
#include <hvi/detail/stages/clock.hpp>
#include <hvi/detail/stages/stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// This Hamiltonian with gauss:2, computed in Number: float, double or long double. States hold
/// Numbers: arrays, or vectors of Eigen of fixed size.
template <class Number, class Numbers = std::array<Number, 1>>
class BasicShakenNewton {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");
    static_assert(hvi::detail::is_fixed_vector<Numbers, Number, 1>(),
                  "hvi: vectors are of these numbers, and of fixed size: std::array, or Eigen's");

public:
    using Scalar = Number;
    using Vector = Numbers;

    /// As the scene has them.
    struct Parameters {
        Scalar a = Scalar(0.5);  // a = 1/2
    };

    /// H = (p-a*sin(t))^2/2+q^4/4, where q is (q) and p is (p).
    struct System {
        using Vector = Numbers;

        constexpr explicit System(const Parameters& parameters) {
            c1_ = parameters.a;
        }

        constexpr void dHdq(const Vector& q, [[maybe_unused]] const Vector& p, [[maybe_unused]]
            Scalar t, Vector& out) const {
            out[0] = q[0] * q[0] * q[0];
        }

        constexpr void dHdp([[maybe_unused]] const Vector& q, const Vector& p, Scalar t, Vector&
            out) const {
            out[0] = p[0] - c1_ * std::sin(t);
        }

        template <class Matrix>
        constexpr void d2Hdq2(const Vector& q, [[maybe_unused]] const Vector& p, [[maybe_unused]]
            Scalar t, Matrix& out) const {
            out(0, 0) = Scalar(3.0) * (q[0] * q[0]);
        }

        template <class Matrix>
        constexpr void d2Hdqdp([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] Scalar t, [[maybe_unused]] Matrix& out) const {
        }

        template <class Matrix>
        constexpr void d2Hdp2([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] Scalar t, Matrix& out) const {
            out(0, 0) = Scalar(1.0);
        }

        Scalar c1_ = 0;
    };

    using Solver = hvi::NewtonOfPairs;

    using State = hvi::TimedState<Vector>;

    BasicShakenNewton() : BasicShakenNewton(Parameters{}) {}
    explicit BasicShakenNewton(const Parameters& parameters) : system_(parameters) {}

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        if (!clock_.begin(x.t, h, c)) { reset(); }
        if (!clock_.ends()) { return Status(Status::Code::not_finite); }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, clock_, s_});
        if (!status.ok()) { return status; }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k] + s_.Lq[1][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k] + s_.Lp[1][k]);
        }
        return clock_.end(x.t, s_.end(x, status.iterations));
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

    static constexpr Scalar c[2] = {
        // c_1 = 1/2-sqrt(3)/6
        rounded(0.21132487f, 0.2113248654051871, 0x1.97p-57, 0x1.96f383f0da826p-57, 0x1.a8p-110),
        // c_2 = 1/2+sqrt(3)/6
        rounded(0.7886751f, 0.7886751345948129, 0x1.35p-56, 0x1.34863e0792becp-56, 0x1.3p-109),
    };

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
                const Scalar Lq_1 = s_.Lq[0][k];
                const Scalar Lq_2 = s_.Lq[1][k];
                const Scalar Lp_1 = s_.Lp[0][k];
                const Scalar Lp_2 = s_.Lp[1][k];
                s_.Lq[0][k] = N[0][0] * Lq_1 + N[0][1] * Lq_2;
                s_.Lq[1][k] = N[1][0] * Lq_1 + N[1][1] * Lq_2;
                s_.Lp[0][k] = N[0][0] * Lp_1 + N[0][1] * Lp_2;
                s_.Lp[1][k] = N[1][0] * Lp_1 + N[1][1] * Lp_2;
            }
            return;
        }
        auto&& slope = hvi::detail::scratch(s_.slope);
        system_.dHdp(s_.at.q, s_.at.p, clock_.start, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lq[0][k] = s_.h * b[0] * slope[k];
            s_.Lq[1][k] = s_.h * b[1] * slope[k];
        }
        system_.dHdq(s_.at.q, s_.at.p, clock_.start, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.h * b[0] * slope[k];
            s_.Lp[1][k] = -s_.h * b[1] * slope[k];
        }
    }

    /// The stage equations of Q_1, Q_2, P_1, P_2, which are solved at once.
    struct Coupled {
        const System& system;
        const hvi::detail::Clock<Scalar, 2>& clock;
        hvi::detail::Stages<Vector, 2, 2>& s;

        static constexpr bool separable = false;
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
                s.change.p[k] = hvi::detail::abs(P_1 - s.P[0][k]) + hvi::detail::abs(P_2
                    - s.P[1][k]);
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
            system.dHdp(s.Q[0], s.P[0], clock.t[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[0][k] = s.h * b[0] * slope[k];
            }
            system.dHdp(s.Q[1], s.P[1], clock.t[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[1][k] = s.h * b[1] * slope[k];
            }
        }

        /// Lp_i = -h b_i dH/dq.
        void forces() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.Q[0], s.P[0], clock.t[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[0][k] = -s.h * b[0] * slope[k];
            }
            system.dHdq(s.Q[1], s.P[1], clock.t[1], slope);
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
    hvi::detail::Clock<Scalar, 2> clock_;
    hvi::detail::Stages<Vector, 2, 2> s_;
    typename Solver::template Iteration<Vector> solver_;
};

using ShakenNewton = BasicShakenNewton<double>;

}  // namespace hvi::generated
