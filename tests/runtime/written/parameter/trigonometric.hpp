// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --basis "1, cos(w*tau), sin(w*tau)" --nodes "0, 1/2, 1" --name Trigonometric
// SPDX-License-Identifier: MIT
//
// A method of its own basis and nodes: symplectic, 3 stages, for general Hamiltonians.
// Basis functions of tau: 1, cos(w*tau), sin(w*tau).
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 0
//     c_2 = 1/2
//     c_3 = 1
//     b_1 = (w-2*sin(w/2))/(2*w-2*w*cos(w/2))
//     b_2 = (w*cos(w/2)-2*sin(w/2))/(w*cos(w/2)-w)
//     b_3 = (w-2*sin(w/2))/(2*w-2*w*cos(w/2))
//     a_1,1 = 0
//     a_1,2 = 0
//     a_1,3 = 0
//     a_2,1 = (w*cos(w/2)+w-4*cos(w/2)*sin(w/2))/(4*w-4*w*cos(w/2)^2)
//     a_2,2 = (w*cos(w/2)-2*sin(w/2))/(2*w*cos(w/2)-2*w)
//     a_2,3 = (w*cos(w/2)+w-4*sin(w/2))/(4*w-4*w*cos(w/2)^2)
//     a_3,1 = (w-2*sin(w/2))/(2*w-2*w*cos(w/2))
//     a_3,2 = (w*cos(w/2)-2*sin(w/2))/(w*cos(w/2)-w)
//     a_3,3 = (w-2*sin(w/2))/(2*w-2*w*cos(w/2))
//     a~_1,1 = (w-2*sin(w/2))/(2*w-2*w*cos(w/2))
//     a~_1,2 =
//         (w^3*cos(w/2)^2+w^3*cos(w/2)+2*w^2*cos(w/2)^2*sin(w/2)+12*w*cos(w/2)^3-4*w^2*cos(w/2)
//         *sin(w/2)-4*w*cos(w/2)^2-2*w^2*sin(w/2)-12*w*cos(w/2)-16*cos(w/2)^2*sin(w/2)+4*w+16*sin(w
//         /2))/(2*w*(w^2*cos(w/2)^2+4*cos(w/2)^4-w^2-8*cos(w/2)^2+4))
//     a~_1,3 = 0
//     a~_2,1 = (w-2*sin(w/2))/(2*w-2*w*cos(w/2))
//     a~_2,2 = (w*cos(w/2)-2*sin(w/2))/(2*w*cos(w/2)-2*w)
//     a~_2,3 = 0
//     a~_3,1 = (w-2*sin(w/2))/(2*w-2*w*cos(w/2))
//     a~_3,2 =
//         (w^3*cos(w/2)^2+8*w*cos(w/2)^4+w^3*cos(w/2)-2*w^2*cos(w/2)^2*sin(w/2)-4*w*cos(w/2)^3-4*w
//         *cos(w/2)^2-16*cos(w/2)^3*sin(w/2)-2*w^2*sin(w/2)+4*w*cos(w/2)-4*w+16*cos(w/2)*sin(w/2))
//         /(2*w*(w^2*cos(w/2)^2+4*cos(w/2)^4-w^2-8*cos(w/2)^2+4))
//     a~_3,3 = 0
//
// Choices:
//
//     Q_1 is not solved for: it is q at the start of the step
//     Q_3 takes no sum of its own: it is q at the end of the step
//     no method at w = 2*pi*k, k = +-1, +-2, ...: coefficients are infinite there
//     no method at w = +-8.98682, +-15.4505, +-21.8082, +-28.1324 (all of size below 32): a weight
//         is zero there
//     slopes at the start of the step are the starting values of the iteration: extrapolation would
//         need coefficients for each value of the parameter
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <hvi/detail/coefficients/parameter.hpp>
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
class Trigonometric {
    static_assert(hvi::detail::check_system<System, false>());

public:
    using Vector = typename System::Vector;
    using Scalar = hvi::detail::ScalarOf<Vector>;
    using State = hvi::State<Vector>;

    /// The weights b, m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, with m_ij + mt_ji = 1 exactly, at one
    /// w, right to a few units in the last place of the largest one.
    struct Coefficients {
        Scalar b[3]{};
        Scalar m[3][3]{};
        Scalar mt[3][3]{};
        Status status;  ///< ok, or why there is no method at this w

        explicit Coefficients(Scalar parameter) {
            using Exponents = std::array<unsigned char, 3>;
            const hvi::detail::AtParameter<Functions, Scalar> at(parameter);
            status = at.status();
            if (!status.ok()) { return; }
            const auto b_1 = at.quotient(3, 4.0, Exponents{1, 2, 0});
            b[0] = hvi::detail::to_scalar<Scalar>(b_1);
            const auto b_2 = at.quotient(4, 2.0, Exponents{1, 2, 0});
            b[1] = hvi::detail::to_scalar<Scalar>(b_2);
            b[2] = hvi::detail::to_scalar<Scalar>(b_1);
            bool exact = true;
            mt[0][0] = Scalar(1.0);
            mt[1][0] = Scalar(1.0);
            mt[2][0] = Scalar(1.0);
            const auto a_2_1 = at.quotient(5, 8.0, Exponents{1, 2, 1});
            exact = hvi::detail::round_complementary(a_2_1 / b_1, m[1][0], mt[0][1]) && exact;
            m[1][1] = Scalar(0.5);
            mt[1][1] = Scalar(0.5);
            const auto a_2_3 = at.quotient(6, 8.0, Exponents{1, 2, 1});
            exact = hvi::detail::round_complementary(a_2_3 / b_1, m[1][2], mt[2][1]) && exact;
            m[2][0] = Scalar(1.0);
            m[2][1] = Scalar(1.0);
            m[2][2] = Scalar(1.0);
            if (!exact) { status = Status(Status::Code::pole); }
        }
    };

    /// Whether there is a method at this w: there is none within 2^-20 max(1, |w|) of the places
    /// that are listed above.
    [[nodiscard]] Status status() const { return coefficients_.status; }

    /// What the constructor computed; zeros unless the status is ok.
    [[nodiscard]] const Coefficients& coefficients() const { return coefficients_; }

    /// `parameter`: w, for w = omega h of a basis that is fitted to the frequency omega and steps
    /// of size h. See status().
    Trigonometric(System system, Scalar parameter)
        : system_(std::move(system)), coefficients_(parameter) {}

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (!coefficients_.status.ok()) { return coefficients_.status; }
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        s_.weigh(coefficients_.b, coefficients_.b);
        if constexpr (Solver::takes_starting_values) { predict(); }

        auto&& slope = hvi::detail::scratch(s_.slope);
        s_.Q[0] = s_.at.q;
        status = solver_.solve(Coupled{system_, coefficients_, s_});
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

    // The coefficients are quotients of functions of w, of x_1 = sin((1/4)*w) and y_1 =
    // cos((1/4)*w).
    struct Functions {
        static constexpr std::array<hvi::detail::Phase, 1> phases{{
            {hvi::detail::Phase::Kind::angle, {0.25, 0.0, 0.0, 0.0, 0.0}},
        }};
        static constexpr std::array<hvi::detail::Expansion, 0> constants{{
        }};
        static constexpr std::array<hvi::detail::Term<3>, 15> terms{{
            // w
            {1.0, {1, 0, 0}},
            // x_1
            {1.0, {0, 1, 0}},
            // y_1
            {1.0, {0, 0, 1}},
            // w*x_1^2 + w*y_1^2 - 4*x_1*y_1
            {1.0, {1, 2, 0}},
            {1.0, {1, 0, 2}},
            {-4.0, {0, 1, 1}},
            // w*x_1^2 - w*y_1^2 + 4*x_1*y_1
            {1.0, {1, 2, 0}},
            {-1.0, {1, 0, 2}},
            {4.0, {0, 1, 1}},
            // w*x_1^2*y_1 + w*y_1^3 + 4*x_1^3 - 4*x_1*y_1^2
            {1.0, {1, 2, 1}},
            {1.0, {1, 0, 3}},
            {4.0, {0, 3, 0}},
            {-4.0, {0, 1, 2}},
            // w*y_1 - 4*x_1
            {1.0, {1, 0, 1}},
            {-4.0, {0, 1, 0}},
        }};
        // Each of the next so many terms, vanishing at 0 to this order.
        static constexpr std::array<hvi::detail::EntireFunction, 7> functions{{
            {hvi::detail::EntireFunction::Role::numerator, 1, 1},
            {hvi::detail::EntireFunction::Role::pole, 1, 1},
            {hvi::detail::EntireFunction::Role::pole, 1, 0},
            {hvi::detail::EntireFunction::Role::weight, 3, 3},
            {hvi::detail::EntireFunction::Role::weight, 3, 3},
            {hvi::detail::EntireFunction::Role::numerator, 4, 3},
            {hvi::detail::EntireFunction::Role::numerator, 2, 3},
        }};
        static constexpr std::size_t length = 10;
        static constexpr double switch_point = 0x1p-16;
        static constexpr Status::Code at_zero = Status::Code::ok;
    };

    /// Starting values: slopes as at the start of the step.
    void predict() {
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
        const Coefficients& c;
        hvi::detail::Stages<Vector, 3, 3>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 3> unknown_q{0, 1, 2};
        static constexpr std::array<std::size_t, 2> unknown_p{0, 1};
        Scalar coefficient_q(std::size_t i, std::size_t j) const { return c.m[i][j]; }
        Scalar coefficient_p(std::size_t j, std::size_t i) const { return c.mt[j][i]; }
        Scalar weight_q(std::size_t j) const { return c.b[j]; }
        Scalar weight_p(std::size_t i) const { return c.b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_1 = hvi::detail::moved(p, e_p + (s.Lp[0][k]
                    + c.mt[0][1] * s.Lp[1][k]));
                const Scalar P_2 = hvi::detail::moved(p, e_p + (s.Lp[0][k]
                    + c.mt[1][1] * s.Lp[1][k]));
                const Scalar P_3 = hvi::detail::moved(p, e_p + (s.Lp[0][k]
                    + c.mt[2][1] * s.Lp[1][k]));
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
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (c.m[1][0] * s.Lq[0][k]
                    + c.m[1][1] * s.Lq[1][k] + c.m[1][2] * s.Lq[2][k]));
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
    Coefficients coefficients_;
    hvi::detail::Stages<Vector, 3, 3> s_;
    typename Solver::template Iteration<Vector> solver_;
};

}  // namespace hvi::generated
