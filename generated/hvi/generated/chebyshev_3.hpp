// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method chebyshev:3
// SPDX-License-Identifier: MIT
//
// chebyshev:3: symplectic, 3 stages, for general Hamiltonians.
// Basis functions of tau: 1, tau, tau^2.
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2-sqrt(2)/4
//     c_2 = 1/2
//     c_3 = 1/2+sqrt(2)/4
//     b_1 = 1/3
//     b_2 = 1/3
//     b_3 = 1/3
//     a_1,1 = 1/6+sqrt(2)/48
//     a_1,2 = 1/6-sqrt(2)/6
//     a_1,3 = 1/6-5*sqrt(2)/48
//     a_2,1 = 1/6+sqrt(2)/8
//     a_2,2 = 1/6
//     a_2,3 = 1/6-sqrt(2)/8
//     a_3,1 = 1/6+5*sqrt(2)/48
//     a_3,2 = 1/6+sqrt(2)/6
//     a_3,3 = 1/6-sqrt(2)/48
//     a~_1,1 = 1/6-sqrt(2)/48
//     a~_1,2 = 1/6-sqrt(2)/8
//     a~_1,3 = 1/6-5*sqrt(2)/48
//     a~_2,1 = 1/6+sqrt(2)/6
//     a~_2,2 = 1/6
//     a~_2,3 = 1/6-sqrt(2)/6
//     a~_3,1 = 1/6+5*sqrt(2)/48
//     a~_3,2 = 1/6+sqrt(2)/8
//     a~_3,3 = 1/6+sqrt(2)/48
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
class Chebyshev3 {
    static_assert(hvi::detail::check_system<System, false>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    explicit Chebyshev3(System system = System{})
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
        // b_1 = 1/3
        rounded(0.33333334f, 0.3333333333333333, 0x1.558p-56, 0x1.5555555555555p-56, 0x1.5p-110),
        // b_2 = 1/3
        rounded(0.33333334f, 0.3333333333333333, 0x1.558p-56, 0x1.5555555555555p-56, 0x1.5p-110),
        // b_3 = 1/3
        rounded(0.33333334f, 0.3333333333333333, 0x1.558p-56, 0x1.5555555555555p-56, 0x1.5p-110),
    };

    // m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, rounded so that m_ij + mt_ji is 1 exactly.
    static constexpr Scalar m[3][3] = {
        {
            // m_1,1 = 1/2+sqrt(2)/16
            rounded(0.5883883f, 0.5883883476483185, -0x1.b78p-55, -0x1.b7ba682764c8ap-55,
                -0x1.68p-108),
            // m_1,2 = 1/2-sqrt(2)/2
            rounded(-0.20710683f, -0.20710678118654746, -0x1.21p-54, -0x1.21165f626cdd5p-54,
                -0x1.6p-109),
            // m_1,3 = 1/2-5*sqrt(2)/16
            rounded(0.058058262f, 0.05805826175840778, 0x1.2dp-56, 0x1.2d481189efd6bp-56,
                0x1.8p-112),
        },
        {
            // m_2,1 = 1/2+3*sqrt(2)/8
            rounded(1.0303301f, 1.0303300858899107, -0x1.27p-54, -0x1.272f38762e5ap-54, -0x1p-109),
            Scalar(0.5),  // m_2,2 = 1/2
            // m_2,3 = 1/2-3*sqrt(2)/8
            rounded(-0.030330062f, -0.030330085889910707, 0x1.27p-54, 0x1.272f38762e5ap-54,
                0x1p-109),
        },
        {
            // m_3,1 = 1/2+5*sqrt(2)/16
            rounded(0.94194174f, 0.9419417382415922, -0x1.2dp-56, -0x1.2d481189efd6bp-56,
                -0x1.8p-112),
            // m_3,2 = 1/2+sqrt(2)/2
            rounded(1.2071068f, 1.2071067811865475, 0x1.21p-54, 0x1.21165f626cdd5p-54, 0x1.6p-109),
            // m_3,3 = 1/2-sqrt(2)/16
            rounded(0.41161168f, 0.4116116523516815, 0x1.b78p-55, 0x1.b7ba682764c8ap-55,
                0x1.68p-108),
        },
    };
    static constexpr Scalar mt[3][3] = {
        {
            // mt_1,1 = 1/2-sqrt(2)/16
            rounded(0.41161168f, 0.4116116523516815, 0x1.b78p-55, 0x1.b7ba682764c8ap-55,
                0x1.68p-108),
            // mt_1,2 = 1/2-3*sqrt(2)/8
            rounded(-0.030330062f, -0.030330085889910707, 0x1.27p-54, 0x1.272f38762e5ap-54,
                0x1p-109),
            // mt_1,3 = 1/2-5*sqrt(2)/16
            rounded(0.058058262f, 0.05805826175840778, 0x1.2dp-56, 0x1.2d481189efd6bp-56,
                0x1.8p-112),
        },
        {
            // mt_2,1 = 1/2+sqrt(2)/2
            rounded(1.2071068f, 1.2071067811865475, 0x1.21p-54, 0x1.21165f626cdd5p-54, 0x1.6p-109),
            Scalar(0.5),  // mt_2,2 = 1/2
            // mt_2,3 = 1/2-sqrt(2)/2
            rounded(-0.20710683f, -0.20710678118654746, -0x1.21p-54, -0x1.21165f626cdd5p-54,
                -0x1.6p-109),
        },
        {
            // mt_3,1 = 1/2+5*sqrt(2)/16
            rounded(0.94194174f, 0.9419417382415922, -0x1.2dp-56, -0x1.2d481189efd6bp-56,
                -0x1.8p-112),
            // mt_3,2 = 1/2+3*sqrt(2)/8
            rounded(1.0303301f, 1.0303300858899107, -0x1.27p-54, -0x1.272f38762e5ap-54, -0x1p-109),
            // mt_3,3 = 1/2+sqrt(2)/16
            rounded(0.5883883f, 0.5883883476483185, -0x1.b78p-55, -0x1.b7ba682764c8ap-55,
                -0x1.68p-108),
        },
    };
    static_assert(hvi::detail::complementary(m, mt), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[3][3] = {
        {
            Scalar(0.7573593128807149), Scalar(-2.34314575050762), Scalar(2.585786437626905),
        },
        {
            Scalar(2.585786437626905), Scalar(-7.0), Scalar(5.414213562373095),
        },
        {
            Scalar(5.414213562373095), Scalar(-13.65685424949238), Scalar(9.242640687119286),
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
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return mt[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_1 = hvi::detail::moved(p, e_p + (mt[0][0] * s.Lp[0][k]
                    + mt[0][1] * s.Lp[1][k] + mt[0][2] * s.Lp[2][k]));
                const Scalar P_2 = hvi::detail::moved(p, e_p + (mt[1][0] * s.Lp[0][k]
                    + mt[1][1] * s.Lp[1][k] + mt[1][2] * s.Lp[2][k]));
                const Scalar P_3 = hvi::detail::moved(p, e_p + (mt[2][0] * s.Lp[0][k]
                    + mt[2][1] * s.Lp[1][k] + mt[2][2] * s.Lp[2][k]));
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
