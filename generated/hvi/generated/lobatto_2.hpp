// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method lobatto:2
// SPDX-License-Identifier: MIT
//
// lobatto:2: symplectic, 2 stages, for general Hamiltonians.
// Basis functions of tau: 1, tau.
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 0
//     c_2 = 1
//     b_1 = 1/2
//     b_2 = 1/2
//     a_1,1 = 0
//     a_1,2 = 0
//     a_2,1 = 1/2
//     a_2,2 = 1/2
//     a~_1,1 = 1/2
//     a~_1,2 = 0
//     a~_2,1 = 1/2
//     a~_2,2 = 0
//
// Choices:
//
//     Q_1 is not solved for: it is q at the start of the step
//     Q_2 takes no sum of its own: it is q at the end of the step
//     2 smaller systems are solved in turn: the stages decouple
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
class Lobatto2 {
    static_assert(hvi::detail::check_system<System, false>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    explicit Lobatto2(System system = System{})
        : system_(std::move(system)) {}

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        if constexpr (Solver::takes_starting_values) { predict(); }

        auto&& slope = hvi::detail::scratch(s_.slope);
        int iterations = 0;
        s_.Q[0] = s_.at.q;
        status = solver_[0].solve(Coupled1{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        system_.dHdp(s_.Q[0], s_.P[0], slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lq[0][k] = s_.h * b[0] * slope[k];
        }
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            const Scalar p = s_.at.p[k];
            const Scalar e_p = s_.remainder.p[k];
            s_.P[1][k] = hvi::detail::moved(p, e_p + (s_.Lp[0][k]));
        }
        status = solver_[1].solve(Coupled2{system_, s_});
        if (!status.ok()) { return status; }
        iterations += status.iterations;
        system_.dHdq(s_.Q[1], s_.P[1], slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[1][k] = -s_.h * b[1] * slope[k];
        }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k] + s_.Lq[1][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k] + s_.Lp[1][k]);
        }
        return s_.end(x, iterations);
    }

    /// Forgets what the last step left: remainders of the sums, slopes, factors of Newton's method.
    void reset() { s_.forget(); }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    static constexpr Scalar b[2] = {
        Scalar(0.5),  // b_1 = 1/2
        Scalar(0.5),  // b_2 = 1/2
    };

    // m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, rounded so that m_ij + mt_ji is 1 exactly.
    static constexpr Scalar m[2][2] = {
        {
            Scalar(0.0),  // m_1,1 = 0
            Scalar(0.0),  // m_1,2 = 0
        },
        {
            Scalar(1.0),  // m_2,1 = 1
            Scalar(1.0),  // m_2,2 = 1
        },
    };
    static constexpr Scalar mt[2][2] = {
        {
            Scalar(1.0),  // mt_1,1 = 1
            Scalar(0.0),  // mt_1,2 = 0
        },
        {
            Scalar(1.0),  // mt_2,1 = 1
            Scalar(0.0),  // mt_2,2 = 0
        },
    };
    static_assert(hvi::detail::complementary(m, mt), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[2][2] = {
        {
            Scalar(0.0), Scalar(1.0),
        },
        {
            Scalar(-1.0), Scalar(2.0),
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
                s_.Lp[0][k] = N[0][0] * Lp_1 + N[0][1] * Lp_2;
                s_.Lq[1][k] = N[1][0] * Lq_1 + N[1][1] * Lq_2;
            }
            return;
        }
        auto&& slope = hvi::detail::scratch(s_.slope);
        system_.dHdp(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lq[1][k] = s_.h * b[1] * slope[k];
        }
        system_.dHdq(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.h * b[0] * slope[k];
        }
    }

    /// The stage equations of P_1, which are solved at once.
    struct Coupled1 {
        const System& system;
        hvi::detail::Stages<Vector, 2, 2>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = false;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 0> unknown_q{};
        static constexpr std::array<std::size_t, 1> unknown_p{0};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return mt[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_1 = hvi::detail::moved(p, e_p + (s.Lp[0][k]));
                s.change.p[k] = hvi::detail::abs(P_1 - s.P[0][k]);
                s.P[0][k] = P_1;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
        }

        /// Lq_j = h b_j dH/dp.
        void velocities() {
        }

        /// Lp_i = -h b_i dH/dq.
        void forces() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.Q[0], s.P[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[0][k] = -s.h * b[0] * slope[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return 0;
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.Lp[0][k]);
        }
    };

    /// The stage equations of Q_2, which are solved at once.
    struct Coupled2 {
        const System& system;
        hvi::detail::Stages<Vector, 2, 2>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = false;
        static constexpr std::array<std::size_t, 1> unknown_q{1};
        static constexpr std::array<std::size_t, 0> unknown_p{};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return mt[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (s.Lq[0][k] + s.Lq[1][k]));
                s.change.q[k] = hvi::detail::abs(Q_2 - s.Q[1][k]);
                s.Q[1][k] = Q_2;
            }
        }

        /// Lq_j = h b_j dH/dp.
        void velocities() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdp(s.Q[1], s.P[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[1][k] = s.h * b[1] * slope[k];
            }
        }

        /// Lp_i = -h b_i dH/dq.
        void forces() {
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[1][k])
                + hvi::detail::abs(s.Lq[1][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return 0;
        }
    };

    System system_;
    hvi::detail::Stages<Vector, 2, 2> s_;
    std::array<typename Solver::template Iteration<Vector>, 2> solver_;
};

}  // namespace hvi::generated
