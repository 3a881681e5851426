// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:4 double-pendulum --solver newton --energy --name NewtonDoublePendulum
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
// Found in H:
//
//     H is not seen to be T(p) + U(q)
//     16 of 16 second derivatives are not zero, 0 constant
//
// Cost:
//
//     16 unknowns are solved for in a step
//     dH/dq once: 7 additions, 19 multiplications, 1 division, 4 calls
//     dH/dp once: 4 additions, 11 multiplications, 1 division, 2 calls
//     second derivatives once, where Newton's method is needed: 20 additions, 58 multiplications, 3
//         divisions, 8 calls
//     evaluations in a step of one iteration: 4 of dH/dq, 4 of dH/dp
//
// Choices:
//
//     the last step's slopes, extrapolated, are the starting values of the iteration: they are good
//         to the order of the interpolation and cost no evaluation
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/newton_pairs.hpp>
#include <hvi/detail/stages/stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene double-pendulum with gauss:4, computed in Number: float, double or long double. States
/// hold Numbers: arrays, or vectors of Eigen of fixed size.
/// Two pendulums, one hanging on the other; not separable
template <class Number, class Numbers = std::array<Number, 2>>
class BasicNewtonDoublePendulum {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");
    static_assert(hvi::detail::is_fixed_vector<Numbers, Number, 2>(),
                  "hvi: vectors are of these numbers, and of fixed size: std::array, or Eigen's");

public:
    using Scalar = Number;
    using Vector = Numbers;

    /// As the scene has them.
    struct Parameters {
        Scalar m1 = Scalar(1.0);  // m1 = 1
        Scalar m2 = Scalar(1.0);  // m2 = 1
        Scalar l1 = Scalar(1.0);  // l1 = 1
        Scalar l2 = Scalar(1.0);  // l2 = 1
        Scalar g = hvi::detail::rounded<Scalar>(9.81f, 9.81, -0x1.1e8p-51, -0x1.1eb851eb851ebp-51,
            -0x1.08p-104);  // g = 981/100
    };

    /// H =
    /// (m2*l2^2*p1^2+(m1+m2)*l1^2*p2^2-2*m2*l1*l2*p1*p2*cos(theta1-theta2))/(2*m2*l1^2*l2^2*(m1+m2
    /// *sin(theta1-theta2)^2))-(m1+m2)*g*l1*cos(theta1)-m2*g*l2*cos(theta2), where q is (theta1,
    /// theta2) and p is (p1, p2).
    struct System {
        using Vector = Numbers;

        constexpr explicit System(const Parameters& parameters) {
            const Scalar t1 = parameters.l2 * parameters.l2;
            const Scalar t2 = parameters.m2 * t1;
            const Scalar t3 = parameters.m1 + parameters.m2;
            const Scalar t4 = parameters.l1 * parameters.l1;
            const Scalar t5 = t3 * t4;
            const Scalar t6 = parameters.m2 * t4;
            const Scalar t7 = Scalar(1.0) / (t1 * t6);
            const Scalar t8 = parameters.m2 * t7;
            const Scalar t9 = parameters.m2 * parameters.l1 * parameters.l2;
            const Scalar t10 = Scalar(2.0) * t9;
            c1_ = parameters.m1;
            c2_ = parameters.m2;
            c3_ = t2;
            c4_ = t5;
            c5_ = t8;
            c6_ = parameters.l1 * parameters.g * t3;
            c7_ = t9 * t7;
            c8_ = parameters.m2 * parameters.l2 * parameters.g;
            c9_ = t10;
            c10_ = t2 * t7;
            c11_ = t5 * t7;
            c12_ = t8 * t10;
            c13_ = t3 * t6 * t7;
            c14_ = parameters.m2 * parameters.m2 * t1 * t7;
            c15_ = t9;
            c16_ = t7;
            c17_ = parameters.g * t3 * parameters.l1;
            c18_ = parameters.m2 * parameters.g * parameters.l2;
        }

        constexpr void dHdq(const Vector& q, const Vector& p, Vector& out) const {
            const Scalar t1 = q[0] - q[1];
            const Scalar t2 = std::cos(t1);
            const Scalar t3 = std::sin(t1);
            const Scalar t4 = Scalar(1.0) / (c1_ + t3 * t3 * c2_);
            const Scalar t5 = t4 * t4 * (t2 * t3 * c5_) * (p[1] * p[1] * c4_
                - p[0] * (p[1] * t2 * c9_ - p[0] * c3_));
            const Scalar t6 = p[0] * t4 * c7_ * (p[1] * t3) - t5;
            out[0] = std::sin(q[0]) * c6_ + t6;
            out[1] = std::sin(q[1]) * c8_ - t6;
        }

        constexpr void dHdp(const Vector& q, const Vector& p, Vector& out) const {
            const Scalar t1 = q[0] - q[1];
            const Scalar t2 = std::cos(t1);
            const Scalar t3 = std::sin(t1);
            const Scalar t4 = Scalar(1.0) / (c1_ + t3 * t3 * c2_);
            const Scalar t5 = p[0] * t4;
            out[0] = -(p[1] * t2 * (t4 * c7_) - c10_ * t5);
            out[1] = -(c7_ * t5 * t2 - t4 * c11_ * p[1]);
        }

        template <class Matrix>
        constexpr void d2Hdq2(const Vector& q, const Vector& p, Matrix& out) const {
            const Scalar t1 = q[0] - q[1];
            const Scalar t2 = std::cos(t1);
            const Scalar t3 = std::sin(t1);
            const Scalar t4 = Scalar(1.0) / (c1_ + t3 * t3 * c2_);
            const Scalar t5 = t2 * t4;
            const Scalar t6 = t3 * t4;
            const Scalar t7 = t4 * t6;
            const Scalar t8 = p[0] * p[1];
            const Scalar t9 = t8 * c7_;
            const Scalar t10 = c5_ * (p[1] * p[1] * c4_ + p[0] * (p[0] * c3_ - t2 * c9_ * p[1]));
            const Scalar t11 = t4 * t9 - t4 * t5 * t10 - Scalar(2.0) * (c2_ * t7 * (t3 * t9
                - Scalar(2.0) * (t2 * t6 * t10)));
            const Scalar t12 = t3 * (t5 * t6 * c12_ * t8 - t7 * t10) - t2 * t11;
            out(0, 0) = std::cos(q[0]) * c6_ - t12;
            out(1, 0) = t12;
            out(1, 1) = std::cos(q[1]) * c8_ - t12;
            for (std::size_t i = 1; i < 2; ++i) {
                for (std::size_t j = 0; j < i; ++j) { out(j, i) = out(i, j); }
            }
        }

        template <class Matrix>
        constexpr void d2Hdqdp(const Vector& q, const Vector& p, Matrix& out) const {
            const Scalar t1 = q[0] - q[1];
            const Scalar t2 = std::cos(t1);
            const Scalar t3 = std::sin(t1);
            const Scalar t4 = Scalar(1.0) / (c1_ + t3 * t3 * c2_);
            const Scalar t5 = t3 * t4;
            const Scalar t6 = c7_ * t5;
            const Scalar t7 = t2 * t4 * t5;
            const Scalar t8 = Scalar(2.0) * (c13_ * t7 * p[1]) - p[0] * (t6 + c12_ * t7 * t2);
            const Scalar t9 = c14_ * t7 * p[0] - p[1] * t6 + c5_ * t7 * (p[0] * c3_
                - t2 * c9_ * p[1]);
            out(0, 0) = -t9;
            out(0, 1) = -t8;
            out(1, 0) = t9;
            out(1, 1) = t8;
        }

        template <class Matrix>
        constexpr void d2Hdp2(const Vector& q, [[maybe_unused]] const Vector& p, Matrix& out) const
            {
            const Scalar t1 = q[0] - q[1];
            const Scalar t2 = std::sin(t1);
            const Scalar t3 = Scalar(1.0) / (c1_ + t2 * t2 * c2_);
            out(0, 0) = t3 * c10_;
            out(1, 0) = -std::cos(t1) * t3 * c7_;
            out(1, 1) = t3 * c11_;
            for (std::size_t i = 1; i < 2; ++i) {
                for (std::size_t j = 0; j < i; ++j) { out(j, i) = out(i, j); }
            }
        }

        [[nodiscard]] constexpr Scalar energy(const Vector& q, const Vector& p) const {
            const Scalar t1 = q[0] - q[1];
            const Scalar t2 = std::sin(t1);
            const Scalar t3 = p[0] * p[0] * c3_ + p[1] * p[1] * c4_
                - Scalar(2.0) * (std::cos(t1) * c15_ * (p[0] * p[1]));
            const Scalar t4 = Scalar(0.5) * (c16_ / (c1_ + t2 * t2 * c2_) * t3)
                - std::cos(q[0]) * c17_ - std::cos(q[1]) * c18_;
            return t4;
        }

        static constexpr void begin([[maybe_unused]] const Parameters& parameters, Vector& q,
            Vector& p) {
            q[0] = k1;
            q[1] = k2;
            p[0] = Scalar(0.0);
            p[1] = Scalar(0.0);
        }

        static constexpr Scalar k1 = hvi::detail::rounded<Scalar>(1.0471976f, 1.0471975511965979,
            -0x1.ee8p-54, -0x1.ee6913347c2a6p-54, -0x1.4p-110);  // pi/3
        static constexpr Scalar k2 = hvi::detail::rounded<Scalar>(0.7853982f, 0.7853981633974483,
            0x1.1a8p-55, 0x1.1a62633145c06p-55, 0x1.cp-108);  // pi/4
        Scalar c1_ = 0;
        Scalar c2_ = 0;
        Scalar c3_ = 0;
        Scalar c4_ = 0;
        Scalar c5_ = 0;
        Scalar c6_ = 0;
        Scalar c7_ = 0;
        Scalar c8_ = 0;
        Scalar c9_ = 0;
        Scalar c10_ = 0;
        Scalar c11_ = 0;
        Scalar c12_ = 0;
        Scalar c13_ = 0;
        Scalar c14_ = 0;
        Scalar c15_ = 0;
        Scalar c16_ = 0;
        Scalar c17_ = 0;
        Scalar c18_ = 0;
    };

    using Solver = hvi::NewtonOfPairs;

    using State = hvi::State<Vector>;

    BasicNewtonDoublePendulum() : BasicNewtonDoublePendulum(Parameters{}) {}
    explicit BasicNewtonDoublePendulum(const Parameters& parameters) : system_(parameters) {}

    /// Where the scene begins.
    [[nodiscard]] static constexpr State initial(const Parameters& parameters) {
        State x;
        System::begin(parameters, x.q, x.p);
        return x;
    }
    [[nodiscard]] static constexpr State initial() { return initial(Parameters{}); }

    /// H =
    /// (m2*l2^2*p1^2+(m1+m2)*l1^2*p2^2-2*m2*l1*l2*p1*p2*cos(theta1-theta2))/(2*m2*l1^2*l2^2*(m1+m2
    /// *sin(theta1-theta2)^2))-(m1+m2)*g*l1*cos(theta1)-m2*g*l2*cos(theta2)
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p);
    }

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

using NewtonDoublePendulum = BasicNewtonDoublePendulum<double>;

}  // namespace hvi::generated
