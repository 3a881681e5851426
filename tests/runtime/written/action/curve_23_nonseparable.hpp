// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --basis "1, tau" --nodes "gauss:3" nonseparable --solver newton --float128 --action --name Curve23Nonseparable
// SPDX-License-Identifier: MIT
//
// A method of its own basis and nodes: symplectic, 2 functions and 3 nodes, for general
// Hamiltonians.
// Basis functions of tau: 1, tau.
// The general Galerkin form (4.6), which conserves q^T C p for constant C.
//
// The rule of (4.6) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2-sqrt(15)/10
//     c_2 = 1/2
//     c_3 = 1/2+sqrt(15)/10
//     b_1 = 5/18
//     b_2 = 4/9
//     b_3 = 5/18
//     A_1,1 = 1/2-sqrt(15)/10
//     A_1,2 = 1/5-sqrt(15)/20
//     A_2,1 = 1/2
//     A_2,2 = 1/8
//     A_3,1 = 1/2+sqrt(15)/10
//     A_3,2 = 1/5+sqrt(15)/20
//     B_1 = 1
//     B_2 = 1/2
//
// Found in H:
//
//     H is not seen to be T(p) + U(q)
//     4 of 4 second derivatives are not zero, 0 constant
//
// Cost:
//
//     5 unknowns are solved for in a step
//     dH/dq and dH/dp once: 2 additions, 3 multiplications
//     second derivatives once, where Newton's method is needed: 2 additions, 4 multiplications
//     evaluations in a step of one iteration: 3 of dH/dq, 3 of dH/dp
//
// Choices:
//
//     the velocities of the curve and the momenta at the nodes are solved for: d2H/dp2 is not seen
//         to be constant, so that neither can be eliminated
//     the basis is orthogonal for the rule: any basis of the span makes the same step, and with
//         this one an iteration needs no matrix larger than d2H/dp2
//     the last step's curve and momenta, extrapolated, are the starting values of the iteration:
//         they are good to the order of the interpolation
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/detail/coefficients/curve_coefficients.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/solvers/newton_curves.hpp>
#include <hvi/detail/stages/action.hpp>
#include <hvi/detail/stages/curve_stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene nonseparable with a method of its own basis and nodes, computed in Number: float,
/// double, long double, or hvi::math::Widest, which is __float128 where libm has functions of it,
/// else long double. States hold Numbers: arrays, or vectors of Eigen of fixed size.
/// A Hamiltonian that is not separable, closed orbits
template <class Number, class Numbers = std::array<Number, 1>>
class BasicCurve23Nonseparable {
    static_assert(hvi::math::computes_in<Number>,
                  "hvi: a scene is computed in float, double, long double or hvi::math::Widest");
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

        [[nodiscard]] constexpr Scalar energy(const Vector& q, const Vector& p) const {
            return Scalar(0.5) * ((Scalar(1.0) + q[0] * q[0]) * (Scalar(1.0) + p[0] * p[0]));
        }

        static constexpr void begin([[maybe_unused]] const Parameters& parameters, Vector& q,
            Vector& p) {
            q[0] = Scalar(-3.0);
            p[0] = Scalar(0.0);
        }
    };

    using Solver = hvi::NewtonOfCurves;

    using State = hvi::State<Vector>;

    BasicCurve23Nonseparable() : BasicCurve23Nonseparable(Parameters{}) {}
    explicit BasicCurve23Nonseparable(const Parameters& parameters) : system_(parameters) {}

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
        s_.weigh(b);

        status = solver_.solve(Coupled{system_, s_});
        if (!status.ok()) { return status; }

        s_.advance(B);
        action_.begin(x, integral_over_step());
        return action_.end(x, s_.end(x, status.iterations));
    }

    /// H_d^+(q_0, p_1), (4.2) of the paper, of the last step, from (q_0, p_0) to (q_1, p_1): the
    /// generating function of type II with q_1 = D_2 H_d^+ and p_0 = D_1 H_d^+, (3.10). A step of
    /// size 0 or that failed leaves that of the one before. Before any step and after reset() it is
    /// NaN.
    [[nodiscard]] Scalar generating_function() const { return action_.of_step(); }

    /// S_d^k, (3.11), of the k steps so far: p_k q_k less the sum over them of p_{l+1} q_{l+1} -
    /// H_d^+(q_l, p_{l+1}), which keeps what rounding cuts off. It begins anew with a step that
    /// does not begin, bit for bit, where the last one ended. It stays, or is NaN, where
    /// generating_function() does and is.
    [[nodiscard]] Scalar action() const { return action_.of_steps(); }

    /// Forgets what the last step left: remainders of the sums, slopes, factors of Newton's method.
    void reset() { s_.forget(); action_.forget(); }

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

    // (4.6) in a basis phi that is orthogonal for the rule: X_ij = b_i phi_j(c_i), A_ij and B_j are
    // its integrals to c_i and to 1, and D_ij = B_j - A_ij, rounded so that this holds exactly, and
    // B_j is the sum of the X_ij.
    static constexpr Scalar X[3][2] = {
        {
            // X_1,1 = 5/18
            rounded(0.2777778f, 0.2777777777777777, 0x1.c7p-54, 0x1.c71c71c71c71cp-54, 0x1.cp-108),
            // X_1,2 = -sqrt(15)/9
            rounded(-0.43033147f, -0.43033148291193524, 0x1.fbp-56, 0x1.fabcc7018c787p-56,
                0x1.cp-110),
        },
        {
            // X_2,1 = 4/9
            rounded(0.44444442f, 0.44444444444444464, -0x1.c7p-53, -0x1.c71c71c71c71cp-53,
                -0x1.cp-107),
            Scalar(0.0),  // X_2,2 = 0
        },
        {
            // X_3,1 = 5/18
            rounded(0.2777778f, 0.2777777777777777, 0x1.c7p-54, 0x1.c71c71c71c71cp-54, 0x1.cp-108),
            // X_3,2 = sqrt(15)/9
            rounded(0.43033147f, 0.43033148291193524, -0x1.fbp-56, -0x1.fabcc7018c787p-56,
                -0x1.cp-110),
        },
    };
    static constexpr Scalar A[3][2] = {
        {
            // A_1,1 = 1/2-sqrt(15)/10
            rounded(0.112701654f, 0.1127016653792583, 0x1.f8p-57, 0x1.f686ffcf96727p-57, 0.0),
            // A_1,2 = -1/5
            rounded(-0.19999999f, -0.19999999999999996, -0x1.998p-55, -0x1.9999999999999p-55,
                -0x1.3p-108),
        },
        {
            Scalar(0.5),   // A_2,1 = 1/2
            Scalar(-0.5),  // A_2,2 = -1/2
        },
        {
            // A_3,1 = 1/2+sqrt(15)/10
            rounded(0.88729835f, 0.8872983346207417, -0x1.f8p-57, -0x1.f686ffcf96727p-57, 0.0),
            // A_3,2 = -1/5
            rounded(-0.19999999f, -0.19999999999999996, -0x1.998p-55, -0x1.9999999999999p-55,
                -0x1.3p-108),
        },
    };
    static constexpr Scalar D[3][2] = {
        {
            // D_1,1 = 1/2+sqrt(15)/10
            rounded(0.88729835f, 0.8872983346207417, -0x1.f8p-57, -0x1.f686ffcf96727p-57, 0.0),
            // D_1,2 = 1/5
            rounded(0.19999999f, 0.19999999999999996, 0x1.998p-55, 0x1.9999999999999p-55,
                0x1.3p-108),
        },
        {
            Scalar(0.5),  // D_2,1 = 1/2
            Scalar(0.5),  // D_2,2 = 1/2
        },
        {
            // D_3,1 = 1/2-sqrt(15)/10
            rounded(0.112701654f, 0.1127016653792583, 0x1.f8p-57, 0x1.f686ffcf96727p-57, 0.0),
            // D_3,2 = 1/5
            rounded(0.19999999f, 0.19999999999999996, 0x1.998p-55, 0x1.9999999999999p-55,
                0x1.3p-108),
        },
    };
    static constexpr Scalar B[2] = {
        Scalar(1.0),  // B_1 = 1
        Scalar(0.0),  // B_2 = 0
    };
    static_assert(hvi::detail::symplectic_curve(X, A, D, B), "the method is symplectic");

    // W and P of the next step are about N_W and N_P times those of this one.
    static constexpr Scalar N_W[2][2] = {
        {
            Scalar(1.0), Scalar(4.0),
        },
        {
            Scalar(0.0), Scalar(1.0),
        },
    };
    static constexpr Scalar N_P[3][3] = {
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

    /// The equations of the 2 W_j and the 3 P_i, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::CurveStages<Vector, 3, 2>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::size_t nodes = 3;
        static constexpr std::size_t functions = 2;

        /// Lp_i = -h b_i dH/dq and Lq_i = h b_i dH/dp.
        void slopes() {
            for (std::size_t i = 0; i < nodes; ++i) {
                Vector dHdq, dHdp;
                system.gradient(s.Q[i], s.P[i], dHdq, dHdp);
                s.set_slopes(i, dHdq, dHdp);
            }
        }

        /// Q_i = q + (e_q + sum_j A_ij W_j).
        void positions() { s.positions(A); }

        [[nodiscard]] Scalar size_q(Index k) const { return s.size_q(k); }
        [[nodiscard]] Scalar size_p(Index k) const { return s.size_p(k); }

        static constexpr const auto& table_X() { return X; }
        static constexpr const auto& table_A() { return A; }
        static constexpr const auto& table_D() { return D; }
        template <class Matrix>
        void second_derivatives(std::size_t i, Matrix& qq, Matrix& qp, Matrix& pp) const {
            system.d2Hdq2(s.Q[i], s.P[i], qq);
            system.d2Hdqdp(s.Q[i], s.P[i], qp);
            system.d2Hdp2(s.Q[i], s.P[i], pp);
        }
    };

    /// The sum over nodes of P_i . (sum_j X_ij W_j) - h b_i H(Q_i, P_i): see (4.2). The last step
    /// has made its curve.
    [[nodiscard]] Scalar integral_over_step() const {
        Scalar sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            sum += hvi::detail::dot(s_.P[i], s_.way(i, X))
                - s_.hb[i] * system_.energy(s_.Q[i], s_.P[i]);
        }
        return sum;
    }

    System system_;
    hvi::detail::CurveStages<Vector, 3, 2> s_;
    typename Solver::template Iteration<Vector> solver_;
    hvi::detail::ActionSum<State> action_;
};

using Curve23Nonseparable = BasicCurve23Nonseparable<double>;

}  // namespace hvi::generated
