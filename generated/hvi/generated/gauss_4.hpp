// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:4
// SPDX-License-Identifier: MIT
//
// gauss:4: symplectic, 4 stages, for general Hamiltonians.
// Basis functions of tau: 1, tau, tau^2, tau^3.
// A == A~: a Runge-Kutta method, which conserves all quadratic invariants.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2-sqrt(525+70*sqrt(30))/70
//     c_2 = 1/2-sqrt(525-70*sqrt(30))/70
//     c_3 = 1/2+sqrt(525-70*sqrt(30))/70
//     c_4 = 1/2+sqrt(525+70*sqrt(30))/70
//     b_1 = 1/4-sqrt(30)/72
//     b_2 = 1/4+sqrt(30)/72
//     b_3 = 1/4+sqrt(30)/72
//     b_4 = 1/4-sqrt(30)/72
//     a_1,1 = 1/8-sqrt(30)/144
//     a_1,2 =
//         1/8+sqrt(525-70*sqrt(30))/1470-sqrt(525+70*sqrt(30))/420+sqrt(30)/144-5*sqrt(630-84
//         *sqrt(30))/2352-sqrt(630+84*sqrt(30))/336
//     a_1,3 =
//         1/8-sqrt(525-70*sqrt(30))/1470-sqrt(525+70*sqrt(30))/420+sqrt(30)/144+5*sqrt(630-84
//         *sqrt(30))/2352-sqrt(630+84*sqrt(30))/336
//     a_1,4 = 1/8-sqrt(525+70*sqrt(30))/105-sqrt(30)/144+sqrt(630+84*sqrt(30))/168
//     a_2,1 =
//         1/8-sqrt(525-70*sqrt(30))/420+sqrt(525+70*sqrt(30))/1470-sqrt(30)/144+sqrt(630-84
//         *sqrt(30))/336+5*sqrt(630+84*sqrt(30))/2352
//     a_2,2 = 1/8+sqrt(30)/144
//     a_2,3 = 1/8-sqrt(525-70*sqrt(30))/105+sqrt(30)/144-sqrt(630-84*sqrt(30))/168
//     a_2,4 =
//         1/8-sqrt(525-70*sqrt(30))/420-sqrt(525+70*sqrt(30))/1470-sqrt(30)/144+sqrt(630-84
//         *sqrt(30))/336-5*sqrt(630+84*sqrt(30))/2352
//     a_3,1 =
//         1/8+sqrt(525-70*sqrt(30))/420+sqrt(525+70*sqrt(30))/1470-sqrt(30)/144-sqrt(630-84
//         *sqrt(30))/336+5*sqrt(630+84*sqrt(30))/2352
//     a_3,2 = 1/8+sqrt(525-70*sqrt(30))/105+sqrt(30)/144+sqrt(630-84*sqrt(30))/168
//     a_3,3 = 1/8+sqrt(30)/144
//     a_3,4 =
//         1/8+sqrt(525-70*sqrt(30))/420-sqrt(525+70*sqrt(30))/1470-sqrt(30)/144-sqrt(630-84
//         *sqrt(30))/336-5*sqrt(630+84*sqrt(30))/2352
//     a_4,1 = 1/8+sqrt(525+70*sqrt(30))/105-sqrt(30)/144-sqrt(630+84*sqrt(30))/168
//     a_4,2 =
//         1/8+sqrt(525-70*sqrt(30))/1470+sqrt(525+70*sqrt(30))/420+sqrt(30)/144-5*sqrt(630-84
//         *sqrt(30))/2352+sqrt(630+84*sqrt(30))/336
//     a_4,3 =
//         1/8-sqrt(525-70*sqrt(30))/1470+sqrt(525+70*sqrt(30))/420+sqrt(30)/144+5*sqrt(630-84
//         *sqrt(30))/2352+sqrt(630+84*sqrt(30))/336
//     a_4,4 = 1/8-sqrt(30)/144
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
class Gauss4 {
    static_assert(hvi::detail::check_system<System, false>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    explicit Gauss4(System system = System{})
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
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k] + s_.Lq[1][k] + s_.Lq[2][k]
                + s_.Lq[3][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k] + s_.Lp[1][k] + s_.Lp[2][k]
                + s_.Lp[3][k]);
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

    static constexpr Scalar b[4] = {
        // b_1 = 1/4-sqrt(30)/72
        rounded(0.17392743f, 0.17392742256872692, 0x1.1bp-58, 0x1.1a9dd4e5038cp-58, 0x1.6p-111),
        // b_2 = 1/4+sqrt(30)/72
        rounded(0.32607257f, 0.32607257743127305, 0x1.b98p-56, 0x1.b9588ac6bf1cfp-56, 0x1.a8p-109),
        // b_3 = 1/4+sqrt(30)/72
        rounded(0.32607257f, 0.32607257743127305, 0x1.b98p-56, 0x1.b9588ac6bf1cfp-56, 0x1.a8p-109),
        // b_4 = 1/4-sqrt(30)/72
        rounded(0.17392743f, 0.17392742256872692, 0x1.1bp-58, 0x1.1a9dd4e5038cp-58, 0x1.6p-111),
    };

    // m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij.
    static constexpr Scalar m[4][4] = {
        {
            Scalar(0.5),  // m_1,1 = 1/2
            // m_1,2 =
            // 1/2+3*sqrt(525-70*sqrt(30))/490-3*sqrt(525+70*sqrt(30))/490-sqrt(630-84*sqrt(30))/98
            // -sqrt(630+84*sqrt(30))/98
            rounded(-0.0815897f, -0.08158975003227997, 0x1.cfp-54, 0x1.ced21c837e0a8p-54,
                0x1.f8p-107),
            // m_1,3 =
            // 1/2-3*sqrt(525-70*sqrt(30))/490-3*sqrt(525+70*sqrt(30))/490+sqrt(630-84*sqrt(30))/98
            // -sqrt(630+84*sqrt(30))/98
            rounded(0.038725913f, 0.03872592656788576, 0.0, 0x1.49c8292641e4p-66, 0.0),
            // m_1,4 = 1/2-57*sqrt(525+70*sqrt(30))/1715+5*sqrt(630+84*sqrt(30))/343
            rounded(-0.02044046f, -0.020440420684040728, 0x1.89p-54, 0x1.8908136d2553ep-54,
                0x1.8p-108),
        },
        {
            // m_2,1 =
            // 1/2-3*sqrt(525-70*sqrt(30))/490+3*sqrt(525+70*sqrt(30))/490+sqrt(630-84*sqrt(30))/98
            // +sqrt(630+84*sqrt(30))/98
            rounded(1.0815897f, 1.08158975003228, -0x1.cfp-54, -0x1.ced21c837e0a8p-54,
                -0x1.f8p-107),
            Scalar(0.5),  // m_2,2 = 1/2
            // m_2,3 = 1/2-57*sqrt(525-70*sqrt(30))/1715-5*sqrt(630-84*sqrt(30))/343
            rounded(-0.0855037f, -0.08550375141051925, -0x1.e3p-54, -0x1.e302b868feb85p-54,
                -0x1.ep-108),
            // m_2,4 =
            // 1/2-3*sqrt(525-70*sqrt(30))/490-3*sqrt(525+70*sqrt(30))/490+sqrt(630-84*sqrt(30))/98
            // -sqrt(630+84*sqrt(30))/98
            rounded(0.038725913f, 0.03872592656788576, 0.0, 0x1.49c8292641e4p-66, 0.0),
        },
        {
            // m_3,1 =
            // 1/2+3*sqrt(525-70*sqrt(30))/490+3*sqrt(525+70*sqrt(30))/490-sqrt(630-84*sqrt(30))/98
            // +sqrt(630+84*sqrt(30))/98
            rounded(0.9612741f, 0.9612740734321142, 0.0, -0x1.49c8292641e4p-66, 0.0),
            // m_3,2 = 1/2+57*sqrt(525-70*sqrt(30))/1715+5*sqrt(630-84*sqrt(30))/343
            rounded(1.0855037f, 1.0855037514105192, 0x1.e3p-54, 0x1.e302b868feb85p-54, 0x1.ep-108),
            Scalar(0.5),  // m_3,3 = 1/2
            // m_3,4 =
            // 1/2+3*sqrt(525-70*sqrt(30))/490-3*sqrt(525+70*sqrt(30))/490-sqrt(630-84*sqrt(30))/98
            // -sqrt(630+84*sqrt(30))/98
            rounded(-0.0815897f, -0.08158975003227997, 0x1.cfp-54, 0x1.ced21c837e0a8p-54,
                0x1.f8p-107),
        },
        {
            // m_4,1 = 1/2+57*sqrt(525+70*sqrt(30))/1715-5*sqrt(630+84*sqrt(30))/343
            rounded(1.0204405f, 1.0204404206840407, -0x1.89p-54, -0x1.8908136d2553ep-54,
                -0x1.8p-108),
            // m_4,2 =
            // 1/2+3*sqrt(525-70*sqrt(30))/490+3*sqrt(525+70*sqrt(30))/490-sqrt(630-84*sqrt(30))/98
            // +sqrt(630+84*sqrt(30))/98
            rounded(0.9612741f, 0.9612740734321142, 0.0, -0x1.49c8292641e4p-66, 0.0),
            // m_4,3 =
            // 1/2-3*sqrt(525-70*sqrt(30))/490+3*sqrt(525+70*sqrt(30))/490+sqrt(630-84*sqrt(30))/98
            // +sqrt(630+84*sqrt(30))/98
            rounded(1.0815897f, 1.08158975003228, -0x1.cfp-54, -0x1.ced21c837e0a8p-54,
                -0x1.f8p-107),
            Scalar(0.5),  // m_4,4 = 1/2
        },
    };
    static_assert(hvi::detail::complementary(m, m), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[4][4] = {
        {
            Scalar(-0.3043475322896335), Scalar(0.5560939709183108),
            Scalar(-1.0294085679737872), Scalar(2.191699902136537),
        },
        {
            Scalar(-3.667677403095109), Scalar(6.246427614654768), Scalar(-9.46401244076669),
            Scalar(11.574646496723345),
        },
        {
            Scalar(-13.783927085129498), Scalar(22.244205449220566), Scalar(-29.80681363156252),
            Scalar(29.836782226170214),
        },
        {
            Scalar(-14.971892910590412), Scalar(23.52091860319091), Scalar(-29.864571097947245),
            Scalar(27.864733549197386),
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
                const Scalar Lq_4 = s_.Lq[3][k];
                const Scalar Lp_1 = s_.Lp[0][k];
                const Scalar Lp_2 = s_.Lp[1][k];
                const Scalar Lp_3 = s_.Lp[2][k];
                const Scalar Lp_4 = s_.Lp[3][k];
                s_.Lq[0][k] = N[0][0] * Lq_1 + N[0][1] * Lq_2 + N[0][2] * Lq_3 + N[0][3] * Lq_4;
                s_.Lq[1][k] = N[1][0] * Lq_1 + N[1][1] * Lq_2 + N[1][2] * Lq_3 + N[1][3] * Lq_4;
                s_.Lq[2][k] = N[2][0] * Lq_1 + N[2][1] * Lq_2 + N[2][2] * Lq_3 + N[2][3] * Lq_4;
                s_.Lq[3][k] = N[3][0] * Lq_1 + N[3][1] * Lq_2 + N[3][2] * Lq_3 + N[3][3] * Lq_4;
                s_.Lp[0][k] = N[0][0] * Lp_1 + N[0][1] * Lp_2 + N[0][2] * Lp_3 + N[0][3] * Lp_4;
                s_.Lp[1][k] = N[1][0] * Lp_1 + N[1][1] * Lp_2 + N[1][2] * Lp_3 + N[1][3] * Lp_4;
                s_.Lp[2][k] = N[2][0] * Lp_1 + N[2][1] * Lp_2 + N[2][2] * Lp_3 + N[2][3] * Lp_4;
                s_.Lp[3][k] = N[3][0] * Lp_1 + N[3][1] * Lp_2 + N[3][2] * Lp_3 + N[3][3] * Lp_4;
            }
            return;
        }
        auto&& slope = hvi::detail::scratch(s_.slope);
        system_.dHdp(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lq[0][k] = s_.hb_q[0] * slope[k];
            s_.Lq[1][k] = s_.hb_q[1] * slope[k];
            s_.Lq[2][k] = s_.hb_q[2] * slope[k];
            s_.Lq[3][k] = s_.hb_q[3] * slope[k];
        }
        system_.dHdq(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.hb_p[0] * slope[k];
            s_.Lp[1][k] = -s_.hb_p[1] * slope[k];
            s_.Lp[2][k] = -s_.hb_p[2] * slope[k];
            s_.Lp[3][k] = -s_.hb_p[3] * slope[k];
        }
    }

    /// The stage equations of Q_1, Q_2, Q_3, Q_4, P_1, P_2, P_3, P_4, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::Stages<Vector, 4, 4>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 4> unknown_q{0, 1, 2, 3};
        static constexpr std::array<std::size_t, 4> unknown_p{0, 1, 2, 3};
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
                    + m[0][1] * s.Lp[1][k] + m[0][2] * s.Lp[2][k] + m[0][3] * s.Lp[3][k]));
                const Scalar P_2 = hvi::detail::moved(p, e_p + (m[1][0] * s.Lp[0][k]
                    + m[1][1] * s.Lp[1][k] + m[1][2] * s.Lp[2][k] + m[1][3] * s.Lp[3][k]));
                const Scalar P_3 = hvi::detail::moved(p, e_p + (m[2][0] * s.Lp[0][k]
                    + m[2][1] * s.Lp[1][k] + m[2][2] * s.Lp[2][k] + m[2][3] * s.Lp[3][k]));
                const Scalar P_4 = hvi::detail::moved(p, e_p + (m[3][0] * s.Lp[0][k]
                    + m[3][1] * s.Lp[1][k] + m[3][2] * s.Lp[2][k] + m[3][3] * s.Lp[3][k]));
                s.change.p[k] = hvi::detail::abs(P_1 - s.P[0][k]) + hvi::detail::abs(P_2
                    - s.P[1][k]) + hvi::detail::abs(P_3 - s.P[2][k]) + hvi::detail::abs(P_4
                    - s.P[3][k]);
                s.P[0][k] = P_1;
                s.P[1][k] = P_2;
                s.P[2][k] = P_3;
                s.P[3][k] = P_4;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_1 = hvi::detail::moved(q, e_q + (m[0][0] * s.Lq[0][k]
                    + m[0][1] * s.Lq[1][k] + m[0][2] * s.Lq[2][k] + m[0][3] * s.Lq[3][k]));
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (m[1][0] * s.Lq[0][k]
                    + m[1][1] * s.Lq[1][k] + m[1][2] * s.Lq[2][k] + m[1][3] * s.Lq[3][k]));
                const Scalar Q_3 = hvi::detail::moved(q, e_q + (m[2][0] * s.Lq[0][k]
                    + m[2][1] * s.Lq[1][k] + m[2][2] * s.Lq[2][k] + m[2][3] * s.Lq[3][k]));
                const Scalar Q_4 = hvi::detail::moved(q, e_q + (m[3][0] * s.Lq[0][k]
                    + m[3][1] * s.Lq[1][k] + m[3][2] * s.Lq[2][k] + m[3][3] * s.Lq[3][k]));
                s.change.q[k] = hvi::detail::abs(Q_1 - s.Q[0][k]) + hvi::detail::abs(Q_2
                    - s.Q[1][k]) + hvi::detail::abs(Q_3 - s.Q[2][k]) + hvi::detail::abs(Q_4
                    - s.Q[3][k]);
                s.Q[0][k] = Q_1;
                s.Q[1][k] = Q_2;
                s.Q[2][k] = Q_3;
                s.Q[3][k] = Q_4;
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
            system.dHdp(s.Q[3], s.P[3], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[3][k] = s.hb_q[3] * slope[k];
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
            system.dHdq(s.Q[3], s.P[3], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[3][k] = -s.hb_p[3] * slope[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[0][k])
                + hvi::detail::abs(s.Q[1][k]) + hvi::detail::abs(s.Q[2][k])
                + hvi::detail::abs(s.Q[3][k]) + hvi::detail::abs(s.Lq[0][k])
                + hvi::detail::abs(s.Lq[1][k]) + hvi::detail::abs(s.Lq[2][k])
                + hvi::detail::abs(s.Lq[3][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.P[1][k]) + hvi::detail::abs(s.P[2][k])
                + hvi::detail::abs(s.P[3][k]) + hvi::detail::abs(s.Lp[0][k])
                + hvi::detail::abs(s.Lp[1][k]) + hvi::detail::abs(s.Lp[2][k])
                + hvi::detail::abs(s.Lp[3][k]);
        }
    };

    System system_;
    hvi::detail::Stages<Vector, 4, 4> s_;
    typename Solver::template Iteration<Vector> solver_;
};

}  // namespace hvi::generated
