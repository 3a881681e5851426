// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:3 kepler --lanes stages --name Kepler3Lanes
// SPDX-License-Identifier: MIT
//
// gauss:3: symplectic, 3 stages, for separable Hamiltonians.
// Basis functions of tau: 1, tau, tau^2.
// A == A~: a Runge-Kutta method, which conserves all quadratic invariants.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2-sqrt(15)/10
//     c_2 = 1/2
//     c_3 = 1/2+sqrt(15)/10
//     b_1 = 5/18
//     b_2 = 4/9
//     b_3 = 5/18
//     a_1,1 = 5/36
//     a_1,2 = 2/9-sqrt(15)/15
//     a_1,3 = 5/36-sqrt(15)/30
//     a_2,1 = 5/36+sqrt(15)/24
//     a_2,2 = 2/9
//     a_2,3 = 5/36-sqrt(15)/24
//     a_3,1 = 5/36+sqrt(15)/30
//     a_3,2 = 2/9+sqrt(15)/15
//     a_3,3 = 5/36
//     a~_i,j = a_i,j
//
// Found in H:
//
//     H = T(p) + U(q), and T is quadratic with a constant matrix
//     6 of 16 second derivatives are not zero, 2 constant
//
// Cost:
//
//     6 unknowns are solved for in a step
//     dH/dq once: 1 addition, 5 multiplications, 1 division, 1 square root
//     dH/dp once: nothing to compute
//     second derivatives once, where Newton's method is needed: 3 additions, 14 multiplications, 1
//         division, 1 square root
//     operations on registers of four stages: a sweep 60, one with a correction 168, its factors
//         273
//     evaluations in a step of one iteration: 3 of dH/dq, 1 of dH/dp
//
// Choices:
//
//     the momenta of the stages are eliminated: the kinetic energy is quadratic: the stages are
//         solved for their positions alone
//     fixed points, and Newton's method for steps on which they are slow: how stiff H is depends on
//         h and on the state
//     the equations of Newton's method decouple: 1 real eigenvalue of A A~ and 1 pair: at the start
//         of a step all stages have the same second derivatives
//     the stages are computed side by side: one evaluation of dH/dq, in vectors of the processor,
//         serves all 3
//     slopes are corrected with one Hessian for all stages where that costs less than sweeps: in
//         the basis of eigenvectors of A the stages decouple, and are corrected side by side
//     the slopes of the last two steps, extrapolated, are the starting values of the iteration: of
//         few stages, those of one step make a polynomial of low order
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <hvi/detail/lanes/velocity_lanes.hpp>
#include <hvi/detail/solvers/automatic_of_lanes.hpp>
#include <hvi/detail/solvers/lane_corrections.hpp>
#include <hvi/detail/solvers/newton_of_lanes.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene kepler with gauss:3, computed in Number: float, double or long double. States hold
/// Numbers: arrays, or vectors of Eigen of fixed size.
/// A planet around a fixed sun, on an ellipse
template <class Number, class Numbers = std::array<Number, 2>>
class BasicKepler3Lanes {
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

        template <class Values, class Value = hvi::detail::ScalarOf<Values>>
        HVI_INLINE_IN_LANES constexpr void dHdq(const Values& q, Values& out) const {
            const Value t1 = q[0] * q[0] + q[1] * q[1];
            const Value t2 = c1_ / (t1 * hvi::math::sqrt(t1));
            out[0] = q[0] * t2;
            out[1] = q[1] * t2;
        }

        template <class Values, class Value = hvi::detail::ScalarOf<Values>>
        HVI_INLINE_IN_LANES constexpr void dHdp(const Values& p, Values& out) const {
            out[0] = p[0];
            out[1] = p[1];
        }

        template <class Values, class Value = hvi::detail::ScalarOf<Values>>
        HVI_INLINE_IN_LANES constexpr void inverse_mass(const Values& p, Values& out) const {
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

    using Solver = hvi::AutomaticOfLanes<hvi::NewtonOfPositionLanes>;

    using State = hvi::State<Vector>;

    BasicKepler3Lanes() : BasicKepler3Lanes(Parameters{}) {}
    explicit BasicKepler3Lanes(const Parameters& parameters) : system_(parameters) {}

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
        s_.drift_freely(system_, cn_lanes);
        predict();

        status = solver_.solve(Coupled{system_, s_, corrections_});
        if (!status.ok()) { return status; }

        s_.advance(system_, cn_lanes);
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
        // b_1 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c7p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
        // b_2 = 4/9
        rounded(0.44444445f, 0.4444444444444444, 0x1.c7p-56, 0x1.c71c71c71c71cp-56, 0x1.cp-110),
        // b_3 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c7p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
    };

    // The momenta are eliminated: n_ij = sum_k a_ik a~_kj/b_j, rounded with c so that n_ij - n_ji
    // is c_i - c_j exactly.
    static constexpr Scalar c[3] = {
        // c_1 = 1/2-sqrt(15)/10
        rounded(0.112701654f, 0.1127016653792583, 0x1.f6p-57, 0x1.f686ffcf96727p-57, 0.0),
        Scalar(0.5),  // c_2 = 1/2
        // c_3 = 1/2+sqrt(15)/10
        rounded(0.88729835f, 0.8872983346207417, -0x1.f6p-57, -0x1.f686ffcf96727p-57, 0.0),
    };
    static constexpr Scalar n[3][3] = {
        {
            // n_1,1 = 1/25
            rounded(0.04000002f, 0.040000000000000036, -0x1.478p-55, -0x1.47ae147ae147ap-55,
                -0x1.cp-108),
            // n_1,2 = 7/40-sqrt(15)/20
            rounded(-0.01864916f, -0.018649167310370807, -0x1.5bp-55, -0x1.5ac8b99fa6cb4p-55,
                -0x1.7p-108),
            // n_1,3 = 2/5-sqrt(15)/10
            rounded(0.012701631f, 0.01270166537925832, -0x1.3ep-57, -0x1.3cac33639cc0cp-57,
                -0x1.8p-112),
        },
        {
            // n_2,1 = 7/40+sqrt(15)/20
            rounded(0.36864918f, 0.3686491673103709, -0x1.d88p-55, -0x1.d86a79938c67ep-55,
                -0x1.ep-109),
            Scalar(0.0625),  // n_2,2 = 1/16
            // n_2,3 = 7/40-sqrt(15)/20
            rounded(-0.01864916f, -0.018649167310370807, -0x1.5bp-55, -0x1.5ac8b99fa6cb4p-55,
                -0x1.7p-108),
        },
        {
            // n_3,1 = 2/5+sqrt(15)/10
            rounded(0.7872983f, 0.7872983346207417, -0x1.4a8p-55, -0x1.4a6e8cc0b2696p-55,
                -0x1.18p-108),
            // n_3,2 = 7/40+sqrt(15)/20
            rounded(0.36864918f, 0.3686491673103709, -0x1.d88p-55, -0x1.d86a79938c67ep-55,
                -0x1.ep-109),
            // n_3,3 = 1/25
            rounded(0.04000002f, 0.040000000000000036, -0x1.478p-55, -0x1.47ae147ae147ap-55,
                -0x1.cp-108),
        },
    };
    static_assert(hvi::detail::symplectic(c, n), "the method is symplectic");

    // Slopes of the next step are about N times those of this one, and N_before times those of the
    // one before.
    static constexpr Scalar N[3][3] = {
        {
            Scalar(13.174733281837), Scalar(-4.367101122913445), Scalar(3.2788486146019302),
        },
        {
            Scalar(182.1919247087923), Scalar(-51.333333333333336), Scalar(23.14140862454104),
        },
        {
            Scalar(443.5838964834373), Scalar(-115.24074201434146), Scalar(44.158600051496336),
        },
    };
    static constexpr Scalar N_before[3][3] = {
        {
            Scalar(-0.36953169939211145), Scalar(1.6591600221727596),
            Scalar(-10.751344435861721),
        },
        {
            Scalar(-5.939257527162285), Scalar(25.666666666666668), Scalar(-156.72740913950437),
        },
        {
            Scalar(-15.915322230804945), Scalar(66.9682909582194), Scalar(-393.59125261433337),
        },
    };

    static constexpr hvi::detail::VelocityTable<Scalar, stages> cn_lanes{c, n};
    static constexpr auto N_lanes = hvi::detail::lane_columns(N);
    static constexpr auto N_before_lanes = hvi::detail::lane_columns(N_before);

    /// The real eigenvalues of C_ij = b_i n_ij, then pairs of complex ones, and the basis in which
    /// C is diagonal but for the pairs. Approximate.
    struct StageModes {
        static constexpr bool exist = true;
        static constexpr std::size_t real_ones = 1;
        static constexpr std::size_t pairs = 1;
        static constexpr Scalar real_parts[2] = {Scalar(0.046360300801824184),
            Scalar(0.0018198495990879087)};
        static constexpr Scalar imaginary_parts[1] = {Scalar(0.038660280191014876)};
        static constexpr Scalar to[3][3] = {
            {Scalar(5.991698084937801), Scalar(0.7120089344723346), Scalar(0.43231211378385836)},
            {Scalar(-5.991698084937801), Scalar(-0.7120089344723346), Scalar(0.5676878862161416)},
            {Scalar(-1.2462132735862315), Scalar(1.828474778870196), Scalar(-0.25773520127343247)},
        };
        static constexpr Scalar from[3][3] = {
            {Scalar(0.07215185205520017), Scalar(-0.08224123057363067),
            Scalar(-0.0601207386193085)},
            {Scalar(0.19013212598604448), Scalar(0.08490414518729823), Scalar(0.5059280818116665)},
            {Scalar(1), Scalar(1), Scalar(0)},
        };
    };

    using Corrections =
        hvi::detail::PositionCorrections<Vector, hvi::detail::HessianInTheMiddle, 3, StageModes>;

    /// Starting values: the polynomial through the slopes of the last two steps, else slopes as at
    /// the start of this one.
    void predict() {
        if (s_.goes_on && has_slopes_before_) {
            s_.extrapolate(N_lanes, N_before_lanes, Lp_before_);
            s_.drifts(system_);
            return;
        }
        has_slopes_before_ = s_.goes_on;
        Lp_before_ = s_.Lp;
        Coupled{system_, s_, corrections_}.predict();
    }

    /// The stage equations of Q_1, Q_2, Q_3, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::VelocityLanes<Vector, 3>& s;
        Corrections& corrections;

        static constexpr hvi::detail::SolverCosts costs{60, 0, 168, 273};

        /// The stages of the starting values.
        void begin_corrections() { positions(); }
        template <class Matrix>
        void hessian_in_the_middle(Matrix& out) const { system.d2Hdq2(s.middle(), out); }

        static constexpr bool separable = true;
        static constexpr bool has_q = true;
        static constexpr bool has_p = false;

        void momenta() {}
        void velocities() {}

        [[gnu::always_inline]] void positions() { s.positions(cn_lanes); }
        [[gnu::always_inline]] void forces() { s.push(system); }

        /// Lp alone.
        [[gnu::always_inline]] void slopes_of_momenta() { s.forces(system); }

        /// Slopes as at the start of the step.
        void predict() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.at.q, slope);
            s.predict(system, slope);
        }

        [[nodiscard]] Scalar size_q(Index k) const { return s.size_q(static_cast<std::size_t>(k)); }

        static constexpr std::size_t stages = 3;
        static constexpr Scalar coefficient(std::size_t j, std::size_t i) { return n[j][i]; }
        void force_at_start(Vector& out) const { system.dHdq(s.at.q, out); }
        template <class Matrix>
        void hessian_at_start(Matrix& out) const { system.d2Hdq2(s.at.q, out); }
        template <class Matrix>
        void hessian(std::size_t i, Matrix& out) const { system.d2Hdq2(s.position(i), out); }
    };

    System system_;
    hvi::detail::VelocityLanes<Vector, 3> s_;
    Corrections corrections_;
    typename Solver::template Iteration<Vector> solver_;
    decltype(s_.Lp) Lp_before_{};  // of the step before the last
    bool has_slopes_before_ = false;  // the last step went on from it
};

using Kepler3Lanes = BasicKepler3Lanes<double>;

}  // namespace hvi::generated
