// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method lobatto:3 kepler --name Lobatto3Kepler
// SPDX-License-Identifier: MIT
//
// lobatto:3: symplectic, 3 stages, for separable Hamiltonians.
// Basis functions of tau: 1, tau, tau^2.
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 0
//     c_2 = 1/2
//     c_3 = 1
//     b_1 = 1/6
//     b_2 = 2/3
//     b_3 = 1/6
//     a_1,1 = 0
//     a_1,2 = 0
//     a_1,3 = 0
//     a_2,1 = 5/24
//     a_2,2 = 1/3
//     a_2,3 = -1/24
//     a_3,1 = 1/6
//     a_3,2 = 2/3
//     a_3,3 = 1/6
//     a~_1,1 = 1/6
//     a~_1,2 = -1/6
//     a~_1,3 = 0
//     a~_2,1 = 1/6
//     a~_2,2 = 1/3
//     a~_2,3 = 0
//     a~_3,1 = 1/6
//     a~_3,2 = 5/6
//     a~_3,3 = 0
//
// Found in H:
//
//     H = T(p) + U(q), and T is quadratic with a constant matrix
//     6 of 16 second derivatives are not zero, 2 constant
//
// Cost:
//
//     2 unknowns are solved for in a step
//     dH/dq once: 1 addition, 5 multiplications, 1 division, 1 square root
//     dH/dp once: nothing to compute
//     second derivatives once, where Newton's method is needed: 3 additions, 14 multiplications, 1
//         division, 1 square root
//     evaluations in a step of one iteration: 2 of dH/dq, 1 of dH/dp
//
// Choices:
//
//     Q_1 is not solved for: it is q at the start of the step
//     Q_3 takes no sum of its own: it is q at the end of the step
//     one force a step is not evaluated: the last one of a step is the first one of the next
//     the momenta of the stages are eliminated: the kinetic energy is quadratic: the stages are
//         solved for their positions alone
//     fixed points, and Newton's method for steps on which they are slow: how stiff H is depends on
//         h and on the state
//     the equations of Newton's method decouple: 1 real eigenvalue of A A~ and 0 pairs: at the
//         start of a step all stages have the same second derivatives
//     the last step's slopes, extrapolated, are the starting values of the iteration: they are good
//         to the order of the interpolation and cost no evaluation
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/automatic.hpp>
#include <hvi/detail/solvers/newton_positions.hpp>
#include <hvi/detail/stages/velocity_stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene kepler with lobatto:3, computed in Number: float, double or long double. States hold
/// Numbers: arrays, or vectors of Eigen of fixed size.
/// A planet around a fixed sun, on an ellipse
template <class Number, class Numbers = std::array<Number, 2>>
class BasicLobatto3Kepler {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");
    static_assert(hvi::detail::is_fixed_vector<Numbers, Number, 2>(),
                  "hvi: vectors are of these numbers, and of fixed size: std::array, or Eigen's");

public:
    using Scalar = Number;
    using Vector = Numbers;

    /// As the scene has them.
    struct Parameters {
        Scalar mu = Scalar(1.0);  // mu = 1
        Scalar ecc = hvi::detail::rounded<Scalar>(0.6f, 0.6, 0x1.9ap-56, 0x1.9999999999999p-56,
            0x1.3p-109);  // ecc = 3/5
    };

    /// H = (px^2+py^2)/2-mu/sqrt(x^2+y^2), where q is (x, y) and p is (px, py).
    struct System {
        using Vector = Numbers;
        static constexpr bool has_diagonal_mass = true;

        constexpr explicit System(const Parameters& parameters) {
            c1_ = parameters.mu;
        }

        constexpr void dHdq(const Vector& q, Vector& out) const {
            const Scalar t1 = q[0] * q[0] + q[1] * q[1];
            const Scalar t2 = c1_ / (t1 * std::sqrt(t1));
            out[0] = q[0] * t2;
            out[1] = q[1] * t2;
        }

        constexpr void dHdp(const Vector& p, Vector& out) const {
            out[0] = p[0];
            out[1] = p[1];
        }

        constexpr void inverse_mass(const Vector& p, Vector& out) const {
            out[0] = p[0];
            out[1] = p[1];
        }

        template <class Matrix>
        constexpr void d2Hdq2(const Vector& q, Matrix& out) const {
            const Scalar t1 = q[1] * q[1];
            const Scalar t2 = q[0] * q[0] + t1;
            const Scalar t3 = std::sqrt(t2);
            const Scalar t4 = Scalar(1.0) / (t2 * t3);
            const Scalar t5 = c1_ * t4;
            const Scalar t6 = t4 * t4 * t3 * c1_;
            const Scalar t7 = q[0] * t6;
            out(0, 0) = t5 - Scalar(3.0) * (q[0] * t7);
            out(1, 0) = -Scalar(3.0) * t7 * q[1];
            out(1, 1) = t5 - Scalar(3.0) * (t1 * t6);
            for (std::size_t i = 1; i < 2; ++i) {
                for (std::size_t j = 0; j < i; ++j) { out(j, i) = out(i, j); }
            }
        }

        static constexpr void begin(const Parameters& parameters, Vector& q, Vector& p) {
            const Scalar t1 = Scalar(1.0) - parameters.ecc;
            const Scalar t2 = std::sqrt(parameters.mu * (Scalar(1.0) + parameters.ecc) / t1);
            q[0] = t1;
            q[1] = Scalar(0.0);
            p[0] = Scalar(0.0);
            p[1] = t2;
        }

        Scalar c1_ = 0;
    };

    using Solver = hvi::Automatic<hvi::NewtonOfPositions>;

    using State = hvi::State<Vector>;

    BasicLobatto3Kepler() : BasicLobatto3Kepler(Parameters{}) {}
    explicit BasicLobatto3Kepler(const Parameters& parameters) : system_(parameters) {}

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
        s_.weigh(system_, b);
        s_.drift_freely(system_, c);
        if (!s_.continues) {
            hvi::detail::fit(force_, s_.n);
            system_.dHdq(s_.at.q, force_);
        }
        if constexpr (Solver::takes_starting_values) { predict(); }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.hb[0] * force_[k];
        }
        s_.drift(system_, 0);
        status = solver_.solve(Coupled{system_, s_});
        if (!status.ok()) { return status; }
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.end_q(k, s_.W[0][k] + (1 - c[1]) * s_.W[1][k]);
        }
        system_.dHdq(s_.at.q, force_);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[2][k] = -s_.hb[2] * force_[k];
        }
        s_.drift(system_, 2);

        s_.end_p(system_);
        return s_.end(x, status.iterations);
    }

    /// Forgets what the last step left: remainders of the sums, slopes, factors of Newton's method.
    void reset() { s_.forget(); }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    // rounded(...) is the number of its comment as float, double, long double or __float128: the
    // one that Scalar is.
    static constexpr auto& rounded = hvi::detail::rounded<Scalar>;

    static constexpr std::size_t stages = 3;

    static constexpr Scalar b[3] = {
        // b_1 = 1/6
        rounded(0.16666667f, 0.16666666666666666, 0x1.558p-57, 0x1.5555555555555p-57, 0x1.5p-111),
        // b_2 = 2/3
        rounded(0.6666667f, 0.6666666666666666, 0x1.558p-55, 0x1.5555555555555p-55, 0x1.5p-109),
        // b_3 = 1/6
        rounded(0.16666667f, 0.16666666666666666, 0x1.558p-57, 0x1.5555555555555p-57, 0x1.5p-111),
    };

    // The momenta are eliminated: n_ij = sum_k a_ik a~_kj/b_j, rounded with c so that n_ij - n_ji
    // is c_i - c_j exactly.
    static constexpr Scalar c[3] = {
        Scalar(0.0),  // c_1 = 0
        Scalar(0.5),  // c_2 = 1/2
        Scalar(1.0),  // c_3 = 1
    };
    static constexpr Scalar n[3][3] = {
        {
            Scalar(0.0),  // n_1,1 = 0
            Scalar(0.0),  // n_1,2 = 0
            Scalar(0.0),  // n_1,3 = 0
        },
        {
            Scalar(0.5),     // n_2,1 = 1/2
            Scalar(0.0625),  // n_2,2 = 1/16
            Scalar(0.0),     // n_2,3 = 0
        },
        {
            Scalar(1.0),  // n_3,1 = 1
            Scalar(0.5),  // n_3,2 = 1/2
            Scalar(0.0),  // n_3,3 = 0
        },
    };
    static_assert(hvi::detail::symplectic(c, n), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[3][3] = {
        {
            Scalar(0.0), Scalar(0.0), Scalar(1.0),
        },
        {
            Scalar(4.0), Scalar(-3.0), Scalar(12.0),
        },
        {
            Scalar(3.0), Scalar(-2.0), Scalar(6.0),
        },
    };

    /// Starting values: the polynomial through the forces of the last step, else forces as at the
    /// start of this one.
    void predict() {
        if (s_.goes_on) {
            for (Index k = 0; k < s_.at.q.size(); ++k) {
                const Scalar W_1 = s_.W[0][k];
                const Scalar W_2 = s_.W[1][k];
                const Scalar W_3 = s_.W[2][k];
                s_.W[1][k] = N[1][0] * W_1 + N[1][1] * W_2 + N[1][2] * W_3;
            }
            return;
        }
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[1][k] = -s_.hb[1] * force_[k];
        }
        s_.drift(system_, 1);
    }

    /// The stage equations of Q_2, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::VelocityStages<Vector, stages>& s;

        static constexpr bool separable = true;
        static constexpr bool has_q = true;
        static constexpr bool has_p = false;

        void momenta() {}
        void velocities() {}

        /// Q_i = q + (e_q + c_i w + sum_j n_ij W_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar Q_2 = hvi::detail::moved(s.at.q[k], s.drifted[1][k] + n[1][0] * s.W[0][k]
                    + n[1][1] * s.W[1][k]);
                s.change.q[k] = hvi::detail::abs(Q_2 - s.Q[1][k]);
                s.Q[1][k] = Q_2;
            }
        }

        /// Lp_i = -h b_i dH/dq, W_i = h K Lp_i.
        void forces() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.Q[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[1][k] = -s.hb[1] * slope[k];
            }
            s.drift(system, 1);
        }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q(Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.free_path[k])
                + hvi::detail::abs(s.Q[1][k]) + hvi::detail::abs(s.W[1][k]);
        }

        static constexpr std::array<std::size_t, 1> unknown{1};
        static constexpr Scalar coefficient(std::size_t i, std::size_t j) { return n[i][j]; }
        /// The real eigenvalues of C_ij = b_i n_ij, then pairs of complex ones, and the basis in
        /// which C is diagonal but for the pairs. Approximate.
        struct Modes {
            static constexpr bool exist = true;
            static constexpr std::size_t real_ones = 1;
            static constexpr std::size_t pairs = 0;
            static constexpr Scalar real_parts[1] = {Scalar(0.041666666666666664)};
            static constexpr Scalar imaginary_parts[1] = {};
            static constexpr Scalar to[1][1] = {
                {Scalar(1)},
            };
            static constexpr Scalar from[1][1] = {
                {Scalar(1)},
            };
        };

        /// W_j = h K Lp_j.
        void drifts() {
            for (const std::size_t j : unknown) {
                s.drift(system, j);
            }
        }

        void force_at_start(Vector& out) const { system.dHdq(s.at.q, out); }
        template <class Matrix>
        void hessian_at_start(Matrix& out) const { system.d2Hdq2(s.at.q, out); }
        template <class Matrix>
        void hessian(std::size_t i, Matrix& out) const { system.d2Hdq2(s.position(i), out); }
    };

    System system_;
    hvi::detail::VelocityStages<Vector, stages> s_;
    typename Solver::template Iteration<Vector> solver_;
    Vector force_{};  // dH/dq at s_.at.q, where the last step ended
};

using Lobatto3Kepler = BasicLobatto3Kepler<double>;

}  // namespace hvi::generated
