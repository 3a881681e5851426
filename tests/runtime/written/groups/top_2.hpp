// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:2 heavy-top --energy --invariants --evaluations --float128 --dense --name TopGauss2
// SPDX-License-Identifier: MIT
//
// gauss:2: symplectic, 2 stages, for Hamiltonians of rotating bodies.
// Basis functions of tau: 1, tau.
// In natural charts, which conserves momentum maps of rotations of space.
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
//     H is of 1 rotation, with three degrees of freedom each
//     12 of 36 second derivatives are not zero, 3 constant
//
// Cost:
//
//     15 unknowns are solved for in a step
//     dH/dq and dH/dp once: 3 additions, 9 multiplications
//     second derivatives once, where Newton's method is needed: 3 additions, 9 multiplications
//     evaluations in a step of one iteration: 2 of dH/dq, 2 of dH/dp
//
// Choices:
//
//     rotations move in a chart at the start of the step, in which they are curves of the method's
//         functions: interpolation in natural charts commutes with rotations of space: momentum
//         maps are kept (Lemmas 5.4 and 5.5)
//     the momentum of a chart at the start is solved for as well: the chart moves with the state;
//         to begin with the momentum of the body makes no symplectic step
//     fixed points, and Newton's method for steps on which they are slow: how stiff H is depends on
//         h and on the state
//     the stages are computed side by side: one evaluation of dH/dq, in vectors of the processor,
//         serves all 2
//     the slopes of the last two steps, extrapolated, are the starting values of the iteration: of
//         few stages, those of one step make a polynomial of low order
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstddef>
#include <utility>

#include <hvi/detail/groups/coupled_chart_lanes.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/solvers/automatic.hpp>
#include <hvi/detail/solvers/newton_charts.hpp>
#include <hvi/detail/stages/curve.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene heavy-top with gauss:2, computed in Number: float, double, long double, or
/// hvi::math::Widest, which is __float128 where libm has functions of it, else long double.
/// A body without symmetry, hung up in gravity
template <class Number>
class BasicTopGauss2 {
    static_assert(hvi::math::computes_in<Number>,
                  "hvi: a scene is computed in float, double, long double or hvi::math::Widest");

public:
    using Scalar = Number;
    using Space = hvi::detail::ChartSpace<Number, 0, 1>;
    using Vector = typename Space::Vector;

    /// Where bodies are: coordinates q, and rotations from body to space, row by row.
    struct Placement {
        std::array<Scalar, 9> R{1, 0, 0, 0, 1, 0, 0, 0, 1};
    };

    /// A placement with momenta p, and angular momenta in the bodies.
    struct Bodies : Placement {
        std::array<Scalar, 3> L{0, 0, 0};
    };

    /// As the numbers q, then R, and p, then L, one after the other.
    [[nodiscard]] static hvi::detail::ChartState<Space> flat(const Bodies& x) {
        hvi::detail::ChartState<Space> at;
        for (std::size_t k = 0; k < 9; ++k) { at.q[0 + k] = x.R[k]; }
        for (std::size_t k = 0; k < 3; ++k) { at.p[0 + k] = x.L[k]; }
        return at;
    }

    /// Sets x to these.
    static void set(Bodies& x, const hvi::detail::ChartState<Space>& at) {
        for (std::size_t k = 0; k < 9; ++k) { x.R[k] = at.q[0 + k]; }
        for (std::size_t k = 0; k < 3; ++k) { x.L[k] = at.p[0 + k]; }
    }

    /// Sets the placement x to q, then R, one after the other.
    static void set(Placement& x, const typename Space::Positions& q) {
        for (std::size_t k = 0; k < 9; ++k) { x.R[k] = q[0 + k]; }
    }

    /// As the scene has them.
    struct Parameters {
        std::array<Scalar, 3> inertia{{
            Scalar(1.0),  // inertia[1] = 1
            Scalar(2.0),  // inertia[2] = 2
            Scalar(3.0),  // inertia[3] = 3
        }};
        std::array<Scalar, 3> centre{{
            // centre[1] = 3/10
            hvi::detail::rounded<Scalar>(0.3f, 0.3, 0x1.9ap-57, 0x1.9999999999999p-57, 0x1.3p-110),
            hvi::detail::rounded<Scalar>(0.1f, 0.1, -0x1.998p-58, -0x1.9999999999999p-58,
                -0x1.3p-111),  // centre[2] = 1/10
            Scalar(1.0),  // centre[3] = 1
        }};
        Scalar m = Scalar(1.0);  // m = 1
        Scalar g = Scalar(1.0);  // g = 1
    };

    /// H =
    /// L[1]^2/(2*inertia[1])+L[2]^2/(2*inertia[2])+L[3]^2/(2*inertia[3])+m*g*(R[3,1]*centre[1]
    /// +R[3,2]*centre[2]+R[3,3]*centre[3]), where q is (R) and p is (L); D, the part of dH/dq that
    /// belongs to a rotation R, is the derivative of H(R exp(hat eta)) by eta.
    struct System {
        using Vector = typename Space::Vector;
        using Positions = typename Space::Positions;

        constexpr explicit System(const Parameters& parameters) {
            const Scalar t1 = parameters.m * parameters.g;
            c1_ = Scalar(1.0) / parameters.inertia[0];
            c2_ = Scalar(1.0) / parameters.inertia[1];
            c3_ = Scalar(1.0) / parameters.inertia[2];
            c4_ = parameters.centre[2] * t1;
            c5_ = parameters.centre[1] * t1;
            c6_ = parameters.centre[0] * t1;
            c7_ = parameters.centre[0];
            c8_ = parameters.centre[1];
            c9_ = parameters.centre[2];
            c10_ = t1;
        }

        template <class Places, class Values, class Value = hvi::detail::ScalarOf<Values>>
        HVI_INLINE_IN_LANES constexpr void gradient(const Places& q, const Values& p, Values& dHdq,
            Values& dHdp) const {
            evaluations += hvi::detail::lane_count<Value>;
            dHdq[0] = q[8] * c5_ - q[7] * c4_;
            dHdq[1] = q[6] * c4_ - q[8] * c6_;
            dHdq[2] = q[7] * c6_ - q[6] * c5_;
            dHdp[0] = p[0] * c1_;
            dHdp[1] = p[1] * c2_;
            dHdp[2] = p[2] * c3_;
        }

        template <class Matrix>
        constexpr void d2Hdq2(const Positions& q, [[maybe_unused]] const Vector& p, Matrix& out)
            const {
            const Scalar t1 = q[8] * c4_;
            const Scalar t2 = q[7] * c5_;
            const Scalar t3 = q[6] * c6_;
            out(0, 0) = -(t1 + t2);
            out(0, 1) = q[6] * c5_;
            out(0, 2) = q[6] * c4_;
            out(1, 0) = q[7] * c6_;
            out(1, 1) = -(t1 + t3);
            out(1, 2) = q[7] * c4_;
            out(2, 0) = q[8] * c6_;
            out(2, 1) = q[8] * c5_;
            out(2, 2) = -(t2 + t3);
        }

        template <class Matrix>
        constexpr void d2Hdqdp([[maybe_unused]] const Positions& q, [[maybe_unused]] const Vector&
            p, [[maybe_unused]] Matrix& out) const {
        }

        template <class Matrix>
        constexpr void d2Hdp2([[maybe_unused]] const Positions& q, [[maybe_unused]] const Vector& p,
            Matrix& out) const {
            out(0, 0) = c1_;
            out(1, 1) = c2_;
            out(2, 2) = c3_;
        }

        [[nodiscard]] constexpr Scalar energy(const Positions& q, const Vector& p) const {
            const Scalar t1 = Scalar(0.5) * (p[0] * p[0] * c1_) + Scalar(0.5) * (p[1] * p[1] * c2_)
                + Scalar(0.5) * (p[2] * p[2] * c3_) + (q[6] * c7_ + q[7] * c8_ + q[8] * c9_) * c10_;
            return t1;
        }

        [[nodiscard]] constexpr Scalar J_z(const Positions& q, const Vector& p) const {
            return q[6] * p[0] + q[7] * p[1] + q[8] * p[2];
        }

        static constexpr void begin([[maybe_unused]] const Parameters& parameters, Positions& q,
            Vector& p) {
            q[0] = k1;
            q[1] = Scalar(0.0);
            q[2] = k2;
            q[3] = Scalar(0.0);
            q[4] = k3;
            q[5] = Scalar(0.0);
            q[6] = k4;
            q[7] = Scalar(0.0);
            q[8] = k1;
            p[0] = Scalar(0.5);
            p[1] = Scalar(1.0);
            p[2] = Scalar(-7) / Scalar(10);
        }

        mutable std::int64_t evaluations = 0;  // of dH/dq

        static constexpr Scalar k1 = Scalar(0.5);  // 1-2*sin(pi/(2*3))^2
        static constexpr Scalar k2 = hvi::detail::rounded<Scalar>(0.8660254f, 0.8660254037844386,
            0x1.cfp-55, 0x1.cec95d0b5c1e2p-55, 0x1.cp-108);  // sin(pi/3)/sqrt(1^2)
        static constexpr Scalar k3 = Scalar(1.0);  // 2*sin(pi/(2*3))^2/1^2+1-2*sin(pi/(2*3))^2
        static constexpr Scalar k4 = hvi::detail::rounded<Scalar>(-0.8660254f, -0.8660254037844386,
            -0x1.cfp-55, -0x1.cec95d0b5c1e2p-55, -0x1.cp-108);  // -sin(pi/3)/sqrt(1^2)
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
    };

    using Solver = hvi::Automatic<hvi::NewtonOfCharts>;

    using State = Bodies;

    BasicTopGauss2() : BasicTopGauss2(Parameters{}) {}
    explicit BasicTopGauss2(const Parameters& parameters) : system_(parameters) {}

    /// Where the scene begins.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        hvi::detail::ChartState<Space> at;
        System::begin(parameters, at.q, at.p);
        State x;
        set(x, at);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H =
    /// L[1]^2/(2*inertia[1])+L[2]^2/(2*inertia[2])+L[3]^2/(2*inertia[3])+m*g*(R[3,1]*centre[1]
    /// +R[3,2]*centre[2]+R[3,3]*centre[3])
    [[nodiscard]] Scalar energy(const State& x) const {
        const hvi::detail::ChartState<Space> at = flat(x);
        return system_.energy(at.q, at.p);
    }

    /// R[3,1]*L[1]+R[3,2]*L[2]+R[3,3]*L[3]
    [[nodiscard]] Scalar J_z(const State& x) const {
        const hvi::detail::ChartState<Space> at = flat(x);
        return system_.J_z(at.q, at.p);
    }

    /// How often dH/dq was evaluated, at one stage each time.
    [[nodiscard]] std::int64_t evaluations() const { return system_.evaluations; }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        hvi::detail::ChartState<Space> at = flat(x);
        Status status = s_.begin(at, h);
        if (!status.ok()) { return status; }
        s_.weigh(b);
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, s_, m, m, lanes});
        const bool is_finite = status.code() != Status::Code::not_finite;
        if (is_finite && !s_.is_in_chart()) {
            return Status(Status::Code::outside_chart, status.iterations);
        }
        if (!status.ok()) { return status; }

        s_.advance();
        status = s_.end(at, status.iterations);
        if (status.ok()) { set(x, at); }
        return status;
    }

    /// Where the bodies are at tau h within the last step, on the curve of the method (Sections 4.1
    /// and 5.4 of the paper): of a rotation R_0 exp(hat xi(tau)). From the exact solution through
    /// its beginning it is O(h^3) away for all tau in [0, 1]. After a step that failed, after
    /// reset() and before any step there are no numbers.
    [[nodiscard]] Placement position(Scalar tau) const {
        Placement x;
        const auto bend = hvi::detail::departures(curve, tau);
        set(x, s_.position(tau, bend));
        return x;
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

    // Slopes of the next step are about N times those of this one, and N_before times those of the
    // one before.
    static constexpr Scalar N[2][2] = {
        {
            Scalar(-4.928203230275509), Scalar(3.1243556529821412),
        },
        {
            Scalar(-21.124355652982143), Scalar(8.928203230275509),
        },
    };
    static constexpr Scalar N_before[2][2] = {
        {
            Scalar(-0.6602540378443865), Scalar(3.4641016151377544),
        },
        {
            Scalar(-3.4641016151377544), Scalar(16.660254037844386),
        },
    };

    static constexpr hvi::detail::ChartTable<Scalar, 2> lanes{m, m};
    static constexpr auto N_lanes = hvi::detail::lane_columns(N);
    static constexpr auto N_before_lanes = hvi::detail::lane_columns(N_before);

    // q_d(tau h) is on the chord but for sum_k curve_ik g_k(tau) times slope i, with g_k(tau) =
    // (P_{k+1}-P_{k-1})(2*tau-1)/2 of Legendre's polynomials P_k.
    static constexpr Scalar curve[2][1] = {
        {
            // curve_1,1 = -sqrt(3)/3
            rounded(-0.57735026f, -0.5773502691896257, -0x1.348p-55, -0x1.34863e0792becp-55,
                -0x1.28p-108),
        },
        {
            // curve_2,1 = sqrt(3)/3
            rounded(0.57735026f, 0.5773502691896257, 0x1.348p-55, 0x1.34863e0792becp-55,
                0x1.28p-108),
        },
    };

    /// Starting values: the polynomial through the slopes of the last two steps, else slopes as at
    /// the start of this one.
    void predict() {
        if (s_.extrapolate(lanes, N_lanes, N_before_lanes)) { return; }
        s_.predict(lanes, [this](const auto& q, const auto& p, auto& dHdq, auto& dHdp) {
            system_.gradient(q, p, dHdq, dHdp);
        });
    }

    using Stages = hvi::detail::ChartLanes<Space, 2>;
    using Coupled = hvi::detail::CoupledChartLanes<System, Stages>;

    System system_;
    Stages s_;
    typename Solver::template Iteration<Vector> solver_;
};

using TopGauss2 = BasicTopGauss2<double>;

}  // namespace hvi::generated
