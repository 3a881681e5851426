// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:2 quartic.toml --lanes ensemble --name Gauss2Quartics
// SPDX-License-Identifier: MIT
//
// gauss:2: symplectic, 2 stages, for separable Hamiltonians.
// Basis functions of tau: 1, tau.
// A == A~: a Runge-Kutta method, which conserves all quadratic invariants.
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
//     H = T(p) + U(q)
//     2 of 4 second derivatives are not zero, 0 constant
//
// Cost:
//
//     4 unknowns are solved for in a step
//     dH/dq once: 1 call
//     dH/dp once: 1 addition, 3 multiplications
//     evaluations in a step of one iteration: 2 of dH/dq, 2 of dH/dp
//
// Choices:
//
//     eight trajectories are computed side by side: one evaluation of dH/dq, in vectors of the
//         processor, serves them all
//     the last step's slopes, extrapolated, are the starting values of the iteration: they are good
//         to the order of the interpolation and cost no evaluation
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <hvi/detail/stepper.hpp>
#include <hvi/detail/trajectories/trajectory_stages.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene quartic with gauss:2, computed in Number: float, double or long double. States hold
/// Numbers: arrays, or vectors of Eigen of fixed size.
/// Separable, and the kinetic energy is not quadratic
/// Eight trajectories go side by side; hvi::Ensemble of <hvi/ensemble.hpp> has any number of them.
template <class Number, class Numbers = std::array<Number, 1>>
class BasicGauss2Quartics {
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

    /// H = p^2/2+p^4/8-cos(q), where q is (q) and p is (p).
    template <class Constant>
    struct SystemOf {
        using Vector = Numbers;

        constexpr explicit SystemOf([[maybe_unused]] const Parameters& parameters) {
        }

        SystemOf() = default;

        /// Gives a lane the constants of one trajectory.
        constexpr void set(std::size_t, const SystemOf<Scalar>&) {}

        template <class Values, class Value = hvi::detail::ScalarOf<Values>>
        constexpr void dHdq(const Values& q, Values& out) const {
            out[0] = hvi::math::sin(q[0]);
        }

        template <class Values, class Value = hvi::detail::ScalarOf<Values>>
        HVI_INLINE_IN_LANES constexpr void dHdp(const Values& p, Values& out) const {
            out[0] = p[0] + Scalar(0.5) * (p[0] * p[0] * p[0]);
        }

        static constexpr void begin([[maybe_unused]] const Parameters& parameters, Vector& q,
            Vector& p) {
            q[0] = Scalar(0.5);
            p[0] = Scalar(0.25);
        }
    };
    using System = SystemOf<Scalar>;
    using LaneSystem = SystemOf<hvi::detail::TrajectoryRow<Scalar>>;

    using Trajectory = hvi::State<Vector>;
    using State = hvi::Trajectories<Vector, hvi::detail::RemaindersCarried>;

    BasicGauss2Quartics() : BasicGauss2Quartics(Parameters{}) {}
    explicit BasicGauss2Quartics(const Parameters& parameters) : one_(parameters) {
        for (std::size_t lane = 0; lane < hvi::trajectories_at_once; ++lane) {
            system_.set(lane, one_);
        }
    }

    /// Gives the trajectory in a lane other parameters. Members that take one trajectory
    /// keep those of the constructor.
    void set_parameters(std::size_t lane, const Parameters& parameters) {
        system_.set(lane, System(parameters));
        reset(lane);
    }

    /// Where the scene begins.
    [[nodiscard]] static constexpr Trajectory initial(const Parameters& parameters) {
        Trajectory x;
        System::begin(parameters, x.q, x.p);
        return x;
    }
    [[nodiscard]] static constexpr Trajectory initial() { return initial(Parameters{}); }

    /// Advances each lane by a step of size h: negative is back, 0 leaves every bit. A lane whose
    /// status is not ok has kept its bits, and is not advanced any more. What becomes of a lane
    /// does not depend on the others.
    [[nodiscard]] const hvi::LaneStatus& step(State& x, Scalar h) {
        if (h == 0) { return x.status(); }
        if (h != common_h_) {
            for (std::size_t lane = 0; lane < hvi::trajectories_at_once; ++lane) {
                set_step(lane, h);
            }
            common_h_ = h;
        }
        return step(x);
    }

    /// Gives a lane a step size of its own, for step(x). Precondition: it is not 0.
    void set_step(std::size_t lane, Scalar h) {
        if (h == h_[lane]) { return; }
        common_h_ = 0;
        h_.set(lane, h);
        s_.resize(lane, h, b);
    }

    /// Advances each lane by a step of its own size. Precondition: each has one, from set_step().
    [[nodiscard]] const hvi::LaneStatus& step(State& x) {
        if (!s_.begin(x)) { return x.status(); }
        if (s_.some_go_on) {
            s_.extrapolate_p(N);
        }
        if (s_.some_begin) {
            const Mask lanes = s_.new_lanes();
            Values slope;
            system_.dHdq(hvi::detail::load(s_.q), slope);
            s_.predict_p(lanes, slope);
        }

        const auto outcome = solver_.solve(Coupled{system_, s_}, x.going());
        return s_.advance(x, outcome);
    }

    /// Forget what the last step left in a lane, or in all: starting values of the next.
    void reset([[maybe_unused]] std::size_t lane) { s_.forget(lane); }
    void reset() { s_.forget(); }

private:
    using Lane = typename State::Lane;
    using Mask = typename State::Mask;
    using Values = typename State::Values;

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

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[2][2] = {
        {
            Scalar(-0.7320508075688773), Scalar(1.7320508075688772),
        },
        {
            Scalar(-1.7320508075688772), Scalar(2.732050807568877),
        },
    };

    /// The stage equations of Q_1, Q_2, P_1, P_2, which are solved at once.
    struct Coupled {
        const LaneSystem& system;
        hvi::detail::PairTrajectories<Vector, 2>& s;

        static constexpr bool separable = true;
        static constexpr bool has_p = true;

        void momenta() { s.momenta(m); }
        void positions() { s.positions(m); }
        void velocities(const typename State::Mask& lanes) {
            s.velocities(lanes, [&](std::size_t i, Values& out) {
                system.dHdp(hvi::detail::load(s.P[i]), out); });
        }
        void forces(const typename State::Mask& lanes) {
            s.forces(lanes, [&](std::size_t i, Values& out) { system.dHdq(hvi::detail::load(s.Q[i]),
                out); });
        }
    };

    System one_;
    LaneSystem system_;
    hvi::detail::TrajectoryRow<Scalar> h_{};
    Scalar common_h_ = 0;  ///< h of all lanes, or 0
    hvi::detail::PairTrajectories<Vector, 2> s_;
    hvi::detail::LaneSweeps<Scalar, hvi::detail::fixed_size<Vector>()> solver_;
};

using Gauss2Quartics = BasicGauss2Quartics<double>;

}  // namespace hvi::generated
