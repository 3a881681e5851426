// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method trig3
// SPDX-License-Identifier: MIT
//
// trig3: symplectic, 3 stages, for general Hamiltonians.
// Basis functions of tau: 1, cos(pi*tau), sin(pi*tau).
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 0
//     c_2 = 1/2
//     c_3 = 1
//     b_1 = 1/2-1/pi
//     b_2 = 2/pi
//     b_3 = 1/2-1/pi
//     a_1,1 = 0
//     a_1,2 = 0
//     a_1,3 = 0
//     a_2,1 = 1/4
//     a_2,2 = 1/pi
//     a_2,3 = 1/4-1/pi
//     a_3,1 = 1/2-1/pi
//     a_3,2 = 2/pi
//     a_3,3 = 1/2-1/pi
//     a~_1,1 = 1/2-1/pi
//     a~_1,2 = (pi-4)/(pi^2-2*pi)
//     a~_1,3 = 0
//     a~_2,1 = 1/2-1/pi
//     a~_2,2 = 1/pi
//     a~_2,3 = 0
//     a~_3,1 = 1/2-1/pi
//     a~_3,2 = 1/(pi-2)
//     a~_3,3 = 0
//
// Choices:
//
//     Q_1 is not solved for: it is q at the start of the step
//     Q_3 takes no sum of its own: it is q at the end of the step
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
class Trig3 {
    static_assert(hvi::detail::check_system<System, false>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    explicit Trig3(System system = System{})
        : system_(std::move(system)) {}

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        s_.weigh(b, b);
        if constexpr (Solver::takes_starting_values) { predict(); }

        auto&& slope = hvi::detail::scratch(s_.slope);
        s_.Q[0] = s_.at.q;
        status = solver_.solve(Coupled{system_, s_});
        if (!status.ok()) { return status; }
        system_.dHdq(s_.Q[2], s_.P[2], slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[2][k] = -s_.hb_p[2] * slope[k];
        }

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
        // b_1 = 1/2-1/pi
        rounded(0.18169011f, 0.18169011381620934, -0x1.2ap-57, -0x1.29fc2757d1f53p-57, -0x1.3p-111),
        // b_2 = 2/pi
        rounded(0.63661975f, 0.6366197723675814, -0x1.6bp-55, -0x1.6b01ec5417056p-55, -0x1.6p-109),
        // b_3 = 1/2-1/pi
        rounded(0.18169011f, 0.18169011381620934, -0x1.2ap-57, -0x1.29fc2757d1f53p-57, -0x1.3p-111),
    };

    // m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, rounded so that m_ij + mt_ji is 1 exactly.
    static constexpr Scalar m[3][3] = {
        {
            Scalar(0.0),  // m_1,1 = 0
            Scalar(0.0),  // m_1,2 = 0
            Scalar(0.0),  // m_1,3 = 0
        },
        {
            // m_2,1 = pi/(2*pi-4)
            rounded(1.3759692f, 1.3759691969420544, -0x1.f88p-54, -0x1.f851261772405p-54,
                -0x1.fp-107),
            Scalar(0.5),  // m_2,2 = 1/2
            // m_2,3 = (pi-4)/(2*pi-4)
            rounded(-0.37596917f, -0.37596919694205444, 0x1.f88p-54, 0x1.f851261772405p-54,
                0x1.fp-107),
        },
        {
            Scalar(1.0),  // m_3,1 = 1
            Scalar(1.0),  // m_3,2 = 1
            Scalar(1.0),  // m_3,3 = 1
        },
    };
    static constexpr Scalar mt[3][3] = {
        {
            Scalar(1.0),  // mt_1,1 = 1
            // mt_1,2 = (pi-4)/(2*pi-4)
            rounded(-0.37596917f, -0.37596919694205444, 0x1.f88p-54, 0x1.f851261772405p-54,
                0x1.fp-107),
            Scalar(0.0),  // mt_1,3 = 0
        },
        {
            Scalar(1.0),  // mt_2,1 = 1
            Scalar(0.5),  // mt_2,2 = 1/2
            Scalar(0.0),  // mt_2,3 = 0
        },
        {
            Scalar(1.0),  // mt_3,1 = 1
            // mt_3,2 = pi/(2*pi-4)
            rounded(1.3759692f, 1.3759691969420544, -0x1.f88p-54, -0x1.f851261772405p-54,
                -0x1.fp-107),
            Scalar(0.0),  // mt_3,3 = 0
        },
    };
    static_assert(hvi::detail::complementary(m, mt), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[3][3] = {
        {
            Scalar(0.0), Scalar(0.0), Scalar(1.0),
        },
        {
            Scalar(3.5038767877682173), Scalar(-3.0), Scalar(10.511630363304652),
        },
        {
            Scalar(3.0), Scalar(-2.2831853071795867), Scalar(6.0),
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
        }
    }

    /// The stage equations of Q_2, Q_3, P_1, P_2, P_3, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::Stages<Vector, 3, 3>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 3> unknown_q{0, 1, 2};
        static constexpr std::array<std::size_t, 2> unknown_p{0, 1};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return mt[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_1 = hvi::detail::moved(p, e_p + (s.Lp[0][k]
                    + mt[0][1] * s.Lp[1][k]));
                const Scalar P_2 = hvi::detail::moved(p, e_p + (s.Lp[0][k]
                    + mt[1][1] * s.Lp[1][k]));
                const Scalar P_3 = hvi::detail::moved(p, e_p + (s.Lp[0][k]
                    + mt[2][1] * s.Lp[1][k]));
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
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (m[1][0] * s.Lq[0][k]
                    + m[1][1] * s.Lq[1][k] + m[1][2] * s.Lq[2][k]));
                const Scalar Q_3 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + s.Lq[1][k]
                    + s.Lq[2][k]));
                s.change.q[k] = hvi::detail::abs(Q_2 - s.Q[1][k]) + hvi::detail::abs(Q_3
                    - s.Q[2][k]);
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
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[1][k])
                + hvi::detail::abs(s.Q[2][k]) + hvi::detail::abs(s.Lq[0][k])
                + hvi::detail::abs(s.Lq[1][k]) + hvi::detail::abs(s.Lq[2][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.P[1][k]) + hvi::detail::abs(s.P[2][k])
                + hvi::detail::abs(s.Lp[0][k]) + hvi::detail::abs(s.Lp[1][k]);
        }
    };

    System system_;
    hvi::detail::Stages<Vector, 3, 3> s_;
    typename Solver::template Iteration<Vector> solver_;
};

}  // namespace hvi::generated
