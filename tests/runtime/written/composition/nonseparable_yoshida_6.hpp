// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method midpoint nonseparable --compose yoshida:6 --name NonseparableYoshida6
// SPDX-License-Identifier: MIT
//
// midpoint: symplectic, 1 stage, for general Hamiltonians.
// Basis functions of tau: 1.
// A == A~: a Runge-Kutta method, which conserves all quadratic invariants.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2
//     b_1 = 1
//     a_1,1 = 1/2
//     a~_i,j = a_i,j
//
// Found in H:
//
//     H is not seen to be T(p) + U(q)
//     4 of 4 second derivatives are not zero, 0 constant
//
// Cost:
//
//     14 unknowns are solved for in a step
//     dH/dq and dH/dp once: 2 additions, 3 multiplications
//     second derivatives once, where Newton's method is needed: 2 additions, 4 multiplications
//     evaluations in a step of one iteration: 7 of dH/dq, 7 of dH/dp
//
// Choices:
//
//     7 steps in a row: they make a method of order 6: yoshida:6
//     7 smaller systems are solved in turn: the stages decouple
//     fixed points, and Newton's method for steps on which they are slow: how stiff H is depends on
//         h and on the state
//     dH/dq and dH/dp are evaluated together: what they have in common is computed once, and
//         neither waits for the other, by the count of operations for less than the iterations that
//         this may add
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/automatic.hpp>
#include <hvi/detail/solvers/newton_pairs.hpp>
#include <hvi/detail/stages/stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene nonseparable with midpoint, computed in Number: float, double or long double. States
/// hold Numbers: arrays, or vectors of Eigen of fixed size.
/// A Hamiltonian that is not separable, closed orbits
template <class Number, class Numbers = std::array<Number, 1>>
class BasicNonseparableYoshida6 {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");
    static_assert(hvi::detail::is_fixed_vector<Numbers, Number, 1>(),
                  "hvi: vectors are of these numbers, and of fixed size: std::array, or Eigen's");

public:
    using Scalar = Number;
    using Vector = Numbers;

    /// As the scene has them.
    struct Parameters {
    };

    /// H = (q^2+1)*(p^2+1)/2, where q is (q) and p is (p).
    struct System {
        using Vector = Numbers;

        constexpr explicit System([[maybe_unused]] const Parameters& parameters) {
        }

        constexpr void gradient(const Vector& q, const Vector& p, Vector& dHdq, Vector& dHdp) const
            {
            const Scalar t1 = q[0] * p[0];
            dHdq[0] = q[0] + p[0] * t1;
            dHdp[0] = p[0] + q[0] * t1;
        }

        template <class Matrix>
        constexpr void d2Hdq2([[maybe_unused]] const Vector& q, const Vector& p, Matrix& out) const
            {
            out(0, 0) = Scalar(1.0) + p[0] * p[0];
        }

        template <class Matrix>
        constexpr void d2Hdqdp(const Vector& q, const Vector& p, Matrix& out) const {
            out(0, 0) = Scalar(2.0) * (q[0] * p[0]);
        }

        template <class Matrix>
        constexpr void d2Hdp2(const Vector& q, [[maybe_unused]] const Vector& p, Matrix& out) const
            {
            out(0, 0) = Scalar(1.0) + q[0] * q[0];
        }

        static constexpr void begin([[maybe_unused]] const Parameters& parameters, Vector& q,
            Vector& p) {
            q[0] = Scalar(-3.0);
            p[0] = Scalar(0.0);
        }
    };

    using Solver = hvi::Automatic<hvi::NewtonOfPairs>;

    using State = hvi::State<Vector>;

    BasicNonseparableYoshida6() : BasicNonseparableYoshida6(Parameters{}) {}
    explicit BasicNonseparableYoshida6(const Parameters& parameters) : system_(parameters) {}

    /// Where the scene begins.
    [[nodiscard]] static constexpr State initial(const Parameters& parameters) {
        State x;
        System::begin(parameters, x.q, x.p);
        return x;
    }
    [[nodiscard]] static constexpr State initial() { return initial(Parameters{}); }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        s_.weigh(b, b);
        if constexpr (Solver::takes_starting_values) { predict(); }

        int iterations = 0;
        status = solver_[0].solve(Coupled1{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        status = solver_[1].solve(Coupled2{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        status = solver_[2].solve(Coupled3{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        status = solver_[3].solve(Coupled4{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        status = solver_[4].solve(Coupled5{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        status = solver_[5].solve(Coupled6{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        status = solver_[6].solve(Coupled7{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k] + s_.Lq[1][k] + s_.Lq[2][k]
                + s_.Lq[3][k] + s_.Lq[4][k] + s_.Lq[5][k] + s_.Lq[6][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k] + s_.Lp[1][k] + s_.Lp[2][k]
                + s_.Lp[3][k] + s_.Lp[4][k] + s_.Lp[5][k] + s_.Lp[6][k]);
        }
        return s_.end(x, iterations);
    }

    /// Forgets what the last step left: remainders of the sums, slopes, factors of Newton's method.
    void reset() { s_.forget(); }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    // rounded(...) is the number of its comment as float, double, long double or __float128: the
    // one that Scalar is.
    static constexpr auto& rounded = hvi::detail::rounded<Scalar>;

    static constexpr Scalar b[7] = {
        // b_1 =
        // 3922568052387786319097488169331749378884122087257466923
        // /5000000000000000000000000000000000000000000000000000000
        rounded(0.7845136f, 0.7845136104775573, -0x1.48p-55, -0x1.4803ffa70445bp-55, -0x1.88p-108),
        // b_2 =
        // 235573213359358133684793182978534601686468082103401119
        // /1000000000000000000000000000000000000000000000000000000
        rounded(0.23557322f, 0.23557321335935813, 0x1.07p-58, 0x1.07706129f494cp-58, 0x1.9p-111),
        // b_3 =
        // -294419996044717751736603920241078933659817313158649621
        // /250000000000000000000000000000000000000000000000000000
        rounded(-1.17768f, -1.177679984178871, -0x1.78p-56, -0x1.7720142977c45p-56, -0x1.cp-109),
        // b_4 =
        // 1643982900854889023605312160298578142939941882699259951
        // /1250000000000000000000000000000000000000000000000000000
        rounded(1.3151863f, 1.3151863206839112, 0x1.c5p-55, 0x1.c54bfb2d032aap-55, 0x1.cp-110),
        // b_5 =
        // -294419996044717751736603920241078933659817313158649621
        // /250000000000000000000000000000000000000000000000000000
        rounded(-1.17768f, -1.177679984178871, -0x1.78p-56, -0x1.7720142977c45p-56, -0x1.cp-109),
        // b_6 =
        // 235573213359358133684793182978534601686468082103401119
        // /1000000000000000000000000000000000000000000000000000000
        rounded(0.23557322f, 0.23557321335935813, 0x1.07p-58, 0x1.07706129f494cp-58, 0x1.9p-111),
        // b_7 =
        // 3922568052387786319097488169331749378884122087257466923
        // /5000000000000000000000000000000000000000000000000000000
        rounded(0.7845136f, 0.7845136104775573, -0x1.48p-55, -0x1.4803ffa70445bp-55, -0x1.88p-108),
    };

    // m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij.
    static constexpr Scalar m[7][7] = {
        {
            Scalar(0.5),  // m_1,1 = 1/2
            Scalar(0.0),  // m_1,2 = 0
            Scalar(0.0),  // m_1,3 = 0
            Scalar(0.0),  // m_1,4 = 0
            Scalar(0.0),  // m_1,5 = 0
            Scalar(0.0),  // m_1,6 = 0
            Scalar(0.0),  // m_1,7 = 0
        },
        {
            Scalar(1.0),  // m_2,1 = 1
            Scalar(0.5),  // m_2,2 = 1/2
            Scalar(0.0),  // m_2,3 = 0
            Scalar(0.0),  // m_2,4 = 0
            Scalar(0.0),  // m_2,5 = 0
            Scalar(0.0),  // m_2,6 = 0
            Scalar(0.0),  // m_2,7 = 0
        },
        {
            Scalar(1.0),  // m_3,1 = 1
            Scalar(1.0),  // m_3,2 = 1
            Scalar(0.5),  // m_3,3 = 1/2
            Scalar(0.0),  // m_3,4 = 0
            Scalar(0.0),  // m_3,5 = 0
            Scalar(0.0),  // m_3,6 = 0
            Scalar(0.0),  // m_3,7 = 0
        },
        {
            Scalar(1.0),  // m_4,1 = 1
            Scalar(1.0),  // m_4,2 = 1
            Scalar(1.0),  // m_4,3 = 1
            Scalar(0.5),  // m_4,4 = 1/2
            Scalar(0.0),  // m_4,5 = 0
            Scalar(0.0),  // m_4,6 = 0
            Scalar(0.0),  // m_4,7 = 0
        },
        {
            Scalar(1.0),  // m_5,1 = 1
            Scalar(1.0),  // m_5,2 = 1
            Scalar(1.0),  // m_5,3 = 1
            Scalar(1.0),  // m_5,4 = 1
            Scalar(0.5),  // m_5,5 = 1/2
            Scalar(0.0),  // m_5,6 = 0
            Scalar(0.0),  // m_5,7 = 0
        },
        {
            Scalar(1.0),  // m_6,1 = 1
            Scalar(1.0),  // m_6,2 = 1
            Scalar(1.0),  // m_6,3 = 1
            Scalar(1.0),  // m_6,4 = 1
            Scalar(1.0),  // m_6,5 = 1
            Scalar(0.5),  // m_6,6 = 1/2
            Scalar(0.0),  // m_6,7 = 0
        },
        {
            Scalar(1.0),  // m_7,1 = 1
            Scalar(1.0),  // m_7,2 = 1
            Scalar(1.0),  // m_7,3 = 1
            Scalar(1.0),  // m_7,4 = 1
            Scalar(1.0),  // m_7,5 = 1
            Scalar(1.0),  // m_7,6 = 1
            Scalar(0.5),  // m_7,7 = 1/2
        },
    };
    static_assert(hvi::detail::complementary(m, m), "the method is symplectic");

    /// Starting values: slopes as at the start of the step.
    void predict() {
        Vector dHdq, dHdp;
        system_.gradient(s_.at.q, s_.at.p, dHdq, dHdp);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.hb_p[0] * dHdq[k];
            s_.Lp[1][k] = -s_.hb_p[1] * dHdq[k];
            s_.Lp[2][k] = -s_.hb_p[2] * dHdq[k];
            s_.Lp[3][k] = -s_.hb_p[3] * dHdq[k];
            s_.Lp[4][k] = -s_.hb_p[4] * dHdq[k];
            s_.Lp[5][k] = -s_.hb_p[5] * dHdq[k];
            s_.Lp[6][k] = -s_.hb_p[6] * dHdq[k];
            s_.Lq[0][k] = s_.hb_q[0] * dHdp[k];
            s_.Lq[1][k] = s_.hb_q[1] * dHdp[k];
            s_.Lq[2][k] = s_.hb_q[2] * dHdp[k];
            s_.Lq[3][k] = s_.hb_q[3] * dHdp[k];
            s_.Lq[4][k] = s_.hb_q[4] * dHdp[k];
            s_.Lq[5][k] = s_.hb_q[5] * dHdp[k];
            s_.Lq[6][k] = s_.hb_q[6] * dHdp[k];
        }
    }

    /// The stage equations of Q_1, P_1, which are solved at once.
    struct Coupled1 {
        const System& system;
        hvi::detail::Stages<Vector, 7, 7>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{0};
        static constexpr std::array<std::size_t, 1> unknown_p{0};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_1 = hvi::detail::moved(p, e_p + (m[0][0] * s.Lp[0][k]));
                s.change.p[k] = hvi::detail::abs(P_1 - s.P[0][k]);
                s.P[0][k] = P_1;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_1 = hvi::detail::moved(q, e_q + (m[0][0] * s.Lq[0][k]));
                s.change.q[k] = hvi::detail::abs(Q_1 - s.Q[0][k]);
                s.Q[0][k] = Q_1;
            }
        }

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            Vector dHdq, dHdp;
            system.gradient(s.Q[0], s.P[0], dHdq, dHdp);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[0][k] = -s.hb_p[0] * dHdq[k];
                s.Lq[0][k] = s.hb_q[0] * dHdp[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[0][k])
                + hvi::detail::abs(s.Lq[0][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.Lp[0][k]);
        }
    };

    /// The stage equations of Q_2, P_2, which are solved at once.
    struct Coupled2 {
        const System& system;
        hvi::detail::Stages<Vector, 7, 7>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{1};
        static constexpr std::array<std::size_t, 1> unknown_p{1};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_2 = hvi::detail::moved(p, e_p + (s.Lp[0][k] + m[1][1] * s.Lp[1][k]));
                s.change.p[k] = hvi::detail::abs(P_2 - s.P[1][k]);
                s.P[1][k] = P_2;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + m[1][1] * s.Lq[1][k]));
                s.change.q[k] = hvi::detail::abs(Q_2 - s.Q[1][k]);
                s.Q[1][k] = Q_2;
            }
        }

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            Vector dHdq, dHdp;
            system.gradient(s.Q[1], s.P[1], dHdq, dHdp);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[1][k] = -s.hb_p[1] * dHdq[k];
                s.Lq[1][k] = s.hb_q[1] * dHdp[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[1][k])
                + hvi::detail::abs(s.Lq[1][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[1][k])
                + hvi::detail::abs(s.Lp[1][k]);
        }
    };

    /// The stage equations of Q_3, P_3, which are solved at once.
    struct Coupled3 {
        const System& system;
        hvi::detail::Stages<Vector, 7, 7>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{2};
        static constexpr std::array<std::size_t, 1> unknown_p{2};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_3 = hvi::detail::moved(p, e_p + (s.Lp[0][k] + s.Lp[1][k]
                    + m[2][2] * s.Lp[2][k]));
                s.change.p[k] = hvi::detail::abs(P_3 - s.P[2][k]);
                s.P[2][k] = P_3;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_3 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + s.Lq[1][k]
                    + m[2][2] * s.Lq[2][k]));
                s.change.q[k] = hvi::detail::abs(Q_3 - s.Q[2][k]);
                s.Q[2][k] = Q_3;
            }
        }

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            Vector dHdq, dHdp;
            system.gradient(s.Q[2], s.P[2], dHdq, dHdp);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[2][k] = -s.hb_p[2] * dHdq[k];
                s.Lq[2][k] = s.hb_q[2] * dHdp[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[2][k])
                + hvi::detail::abs(s.Lq[2][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[2][k])
                + hvi::detail::abs(s.Lp[2][k]);
        }
    };

    /// The stage equations of Q_4, P_4, which are solved at once.
    struct Coupled4 {
        const System& system;
        hvi::detail::Stages<Vector, 7, 7>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{3};
        static constexpr std::array<std::size_t, 1> unknown_p{3};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_4 = hvi::detail::moved(p, e_p + (s.Lp[0][k] + s.Lp[1][k] + s.Lp[2][k]
                    + m[3][3] * s.Lp[3][k]));
                s.change.p[k] = hvi::detail::abs(P_4 - s.P[3][k]);
                s.P[3][k] = P_4;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_4 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + s.Lq[1][k] + s.Lq[2][k]
                    + m[3][3] * s.Lq[3][k]));
                s.change.q[k] = hvi::detail::abs(Q_4 - s.Q[3][k]);
                s.Q[3][k] = Q_4;
            }
        }

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            Vector dHdq, dHdp;
            system.gradient(s.Q[3], s.P[3], dHdq, dHdp);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[3][k] = -s.hb_p[3] * dHdq[k];
                s.Lq[3][k] = s.hb_q[3] * dHdp[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[3][k])
                + hvi::detail::abs(s.Lq[3][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[3][k])
                + hvi::detail::abs(s.Lp[3][k]);
        }
    };

    /// The stage equations of Q_5, P_5, which are solved at once.
    struct Coupled5 {
        const System& system;
        hvi::detail::Stages<Vector, 7, 7>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{4};
        static constexpr std::array<std::size_t, 1> unknown_p{4};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_5 = hvi::detail::moved(p, e_p + (s.Lp[0][k] + s.Lp[1][k] + s.Lp[2][k]
                    + s.Lp[3][k] + m[4][4] * s.Lp[4][k]));
                s.change.p[k] = hvi::detail::abs(P_5 - s.P[4][k]);
                s.P[4][k] = P_5;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_5 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + s.Lq[1][k] + s.Lq[2][k]
                    + s.Lq[3][k] + m[4][4] * s.Lq[4][k]));
                s.change.q[k] = hvi::detail::abs(Q_5 - s.Q[4][k]);
                s.Q[4][k] = Q_5;
            }
        }

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            Vector dHdq, dHdp;
            system.gradient(s.Q[4], s.P[4], dHdq, dHdp);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[4][k] = -s.hb_p[4] * dHdq[k];
                s.Lq[4][k] = s.hb_q[4] * dHdp[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[4][k])
                + hvi::detail::abs(s.Lq[4][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[4][k])
                + hvi::detail::abs(s.Lp[4][k]);
        }
    };

    /// The stage equations of Q_6, P_6, which are solved at once.
    struct Coupled6 {
        const System& system;
        hvi::detail::Stages<Vector, 7, 7>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{5};
        static constexpr std::array<std::size_t, 1> unknown_p{5};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_6 = hvi::detail::moved(p, e_p + (s.Lp[0][k] + s.Lp[1][k] + s.Lp[2][k]
                    + s.Lp[3][k] + s.Lp[4][k] + m[5][5] * s.Lp[5][k]));
                s.change.p[k] = hvi::detail::abs(P_6 - s.P[5][k]);
                s.P[5][k] = P_6;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_6 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + s.Lq[1][k] + s.Lq[2][k]
                    + s.Lq[3][k] + s.Lq[4][k] + m[5][5] * s.Lq[5][k]));
                s.change.q[k] = hvi::detail::abs(Q_6 - s.Q[5][k]);
                s.Q[5][k] = Q_6;
            }
        }

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            Vector dHdq, dHdp;
            system.gradient(s.Q[5], s.P[5], dHdq, dHdp);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[5][k] = -s.hb_p[5] * dHdq[k];
                s.Lq[5][k] = s.hb_q[5] * dHdp[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[5][k])
                + hvi::detail::abs(s.Lq[5][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[5][k])
                + hvi::detail::abs(s.Lp[5][k]);
        }
    };

    /// The stage equations of Q_7, P_7, which are solved at once.
    struct Coupled7 {
        const System& system;
        hvi::detail::Stages<Vector, 7, 7>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{6};
        static constexpr std::array<std::size_t, 1> unknown_p{6};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_7 = hvi::detail::moved(p, e_p + (s.Lp[0][k] + s.Lp[1][k] + s.Lp[2][k]
                    + s.Lp[3][k] + s.Lp[4][k] + s.Lp[5][k] + m[6][6] * s.Lp[6][k]));
                s.change.p[k] = hvi::detail::abs(P_7 - s.P[6][k]);
                s.P[6][k] = P_7;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_7 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + s.Lq[1][k] + s.Lq[2][k]
                    + s.Lq[3][k] + s.Lq[4][k] + s.Lq[5][k] + m[6][6] * s.Lq[6][k]));
                s.change.q[k] = hvi::detail::abs(Q_7 - s.Q[6][k]);
                s.Q[6][k] = Q_7;
            }
        }

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            Vector dHdq, dHdp;
            system.gradient(s.Q[6], s.P[6], dHdq, dHdp);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[6][k] = -s.hb_p[6] * dHdq[k];
                s.Lq[6][k] = s.hb_q[6] * dHdp[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[6][k])
                + hvi::detail::abs(s.Lq[6][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[6][k])
                + hvi::detail::abs(s.Lp[6][k]);
        }
    };

    System system_;
    hvi::detail::Stages<Vector, 7, 7> s_;
    std::array<typename Solver::template Iteration<Vector>, 7> solver_;
};

using NonseparableYoshida6 = BasicNonseparableYoshida6<double>;

}  // namespace hvi::generated
