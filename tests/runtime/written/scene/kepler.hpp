// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:4 kepler --energy --invariants --name Kepler
// SPDX-License-Identifier: MIT
//
// gauss:4: symplectic, 4 stages, for separable Hamiltonians.
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
//     H = T(p) + U(q), and T is quadratic with a constant matrix
//     6 of 16 second derivatives are not zero, 2 constant
//
// Cost:
//
//     8 unknowns are solved for in a step
//     dH/dq once: 1 addition, 5 multiplications, 1 division, 1 square root
//     dH/dp once: nothing to compute
//     second derivatives once, where Newton's method is needed: 3 additions, 14 multiplications, 1
//         division, 1 square root
//     operations on registers of four stages: a sweep 62, one with a correction 174, its factors
//         273
//     evaluations in a step of one iteration: 4 of dH/dq, 1 of dH/dp
//
// Choices:
//
//     the momenta of the stages are eliminated: the kinetic energy is quadratic: the stages are
//         solved for their positions alone
//     fixed points, and Newton's method for steps on which they are slow: how stiff H is depends on
//         h and on the state
//     the equations of Newton's method decouple: 0 real eigenvalues of A A~ and 2 pairs: at the
//         start of a step all stages have the same second derivatives
//     the stages are computed side by side: one evaluation of dH/dq, in vectors of the processor,
//         serves all 4
//     slopes are corrected with one Hessian for all stages where that costs less than sweeps: in
//         the basis of eigenvectors of A the stages decouple, and are corrected side by side
//     the slopes of the last two steps, extrapolated by the nearest polynomial of degree 6, are the
//         starting values of the iteration: of few stages, those of one step make a polynomial of
//         low order
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

/// The scene kepler with gauss:4, computed in Number: float, double or long double. States hold
/// Numbers: arrays, or vectors of Eigen of fixed size.
/// A planet around a fixed sun, on an ellipse
template <class Number, class Numbers = std::array<Number, 2>>
class BasicKepler {
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

        [[nodiscard]] constexpr Scalar energy(const Vector& q, const Vector& p) const {
            const Scalar t1 = Scalar(0.5) * (p[0] * p[0] + p[1] * p[1])
                - c1_ / std::sqrt(q[0] * q[0] + q[1] * q[1]);
            return t1;
        }

        [[nodiscard]] constexpr Scalar angular_momentum(const Vector& q, const Vector& p) const {
            return q[0] * p[1] - q[1] * p[0];
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

    BasicKepler() : BasicKepler(Parameters{}) {}
    explicit BasicKepler(const Parameters& parameters) : system_(parameters) {}

    /// Where the scene begins.
    [[nodiscard]] static constexpr State initial(const Parameters& parameters) {
        State x;
        System::begin(parameters, x.q, x.p);
        return x;
    }
    [[nodiscard]] static constexpr State initial() { return initial(Parameters{}); }

    /// H = (px^2+py^2)/2-mu/sqrt(x^2+y^2)
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p);
    }

    /// x*py-y*px
    [[nodiscard]] Scalar angular_momentum(const State& x) const {
        return system_.angular_momentum(x.q, x.p);
    }

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

    static constexpr std::size_t stages = 4;

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

    // The momenta are eliminated: n_ij = sum_k a_ik a~_kj/b_j, rounded with c so that n_ij - n_ji
    // is c_i - c_j exactly.
    static constexpr Scalar c[4] = {
        // c_1 = 1/2-sqrt(525+70*sqrt(30))/70
        rounded(0.06943184f, 0.06943184420297366, 0x1.f38p-55, 0x1.f39cc39b732b5p-55, 0x1.08p-108),
        // c_2 = 1/2-sqrt(525-70*sqrt(30))/70
        rounded(0.33000946f, 0.33000947820757187, -0x1.14p-58, -0x1.146188781babdp-58, 0.0),
        // c_3 = 1/2+sqrt(525-70*sqrt(30))/70
        rounded(0.66999054f, 0.6699905217924281, 0x1.14p-58, 0x1.146188781babdp-58, 0.0),
        // c_4 = 1/2+sqrt(525+70*sqrt(30))/70
        rounded(0.93056816f, 0.9305681557970263, -0x1.f38p-55, -0x1.f39cc39b732b5p-55,
            -0x1.08p-108),
    };
    static constexpr Scalar n[4][4] = {
        {
            // n_1,1 = 45/1372-3*sqrt(30)/1715
            rounded(0.023217678f, 0.02321768120982215, 0x1.42p-56, 0x1.41c5614f9b80cp-56, 0x1p-113),
            // n_1,2 = 3/14+sqrt(525-70*sqrt(30))/140-sqrt(525+70*sqrt(30))/140-9*sqrt(105)/980
            rounded(-0.010107756f, -0.010107752608050524, 0x1.2fp-55, 0x1.2f6643c502f33p-55,
                0x1.8p-111),
            // n_1,3 = 3/14-sqrt(525-70*sqrt(30))/140-sqrt(525+70*sqrt(30))/140+9*sqrt(105)/980
            rounded(0.008111f, 0.008111025382452675, 0x1.cfcp-54, 0x1.cfd21b58eef78p-54,
                0x1.2p-110),
            // n_1,4 = 57/196-sqrt(525+70*sqrt(30))/70+6*sqrt(30)/245
            rounded(-0.005615711f, -0.00561569273453677, 0x1.49cp-53, 0x1.49cdc69b8ca98p-53,
                0x1.4p-107),
        },
        {
            // n_2,1 = 3/14-sqrt(525-70*sqrt(30))/140+sqrt(525+70*sqrt(30))/140-9*sqrt(105)/980
            rounded(0.25046986f, 0.2504698813965477, -0x1.cep-56, -0x1.cd8561cae75b4p-56,
                -0x1.8p-112),
            // n_2,2 = 45/1372+3*sqrt(30)/1715
            rounded(0.042379975f, 0.04237998642866181, -0x1.94p-57, -0x1.94b54d71afea5p-57,
                -0x1.cp-110),
            // n_2,3 = 57/196-sqrt(525-70*sqrt(30))/70-6*sqrt(30)/245
            rounded(-0.013310373f, -0.013310331793693342, 0x1.66p-55, 0x1.65ee5dfee43ecp-55,
                0x1.e8p-108),
            // n_2,4 = 3/14-sqrt(525-70*sqrt(30))/140-sqrt(525+70*sqrt(30))/140+9*sqrt(105)/980
            rounded(0.008111f, 0.008111025382452675, 0x1.cfcp-54, 0x1.cfd21b58eef78p-54,
                0x1.2p-110),
        },
        {
            // n_3,1 = 3/14+sqrt(525-70*sqrt(30))/140+sqrt(525+70*sqrt(30))/140+9*sqrt(105)/980
            rounded(0.6086697f, 0.6086697029719071, 0x1.ce8p-55, 0x1.ce93a4256e392p-55, 0x1p-109),
            // n_3,2 = 57/196+sqrt(525-70*sqrt(30))/70-6*sqrt(30)/245
            rounded(0.3266707f, 0.3266707117911629, 0x1.abp-55, 0x1.ab06c01ceb29cp-55, 0x1.ap-110),
            // n_3,3 = 45/1372+3*sqrt(30)/1715
            rounded(0.042379975f, 0.04237998642866181, -0x1.94p-57, -0x1.94b54d71afea5p-57,
                -0x1.cp-110),
            // n_3,4 = 3/14+sqrt(525-70*sqrt(30))/140-sqrt(525+70*sqrt(30))/140-9*sqrt(105)/980
            rounded(-0.010107756f, -0.010107752608050524, 0x1.2fp-55, 0x1.2f6643c502f33p-55,
                0x1.8p-111),
        },
        {
            // n_4,1 = 57/196+sqrt(525+70*sqrt(30))/70+6*sqrt(30)/245
            rounded(0.8555206f, 0.8555206188595159, 0x1.4p-55, 0x1.3ffd93374c4f6p-55, 0x1.cp-110),
            // n_4,2 = 3/14+sqrt(525-70*sqrt(30))/140+sqrt(525+70*sqrt(30))/140+9*sqrt(105)/980
            rounded(0.6086697f, 0.6086697029719071, 0x1.ce8p-55, 0x1.ce93a4256e392p-55, 0x1p-109),
            // n_4,3 = 3/14-sqrt(525-70*sqrt(30))/140+sqrt(525+70*sqrt(30))/140-9*sqrt(105)/980
            rounded(0.25046986f, 0.2504698813965477, -0x1.cep-56, -0x1.cd8561cae75b4p-56,
                -0x1.8p-112),
            // n_4,4 = 45/1372-3*sqrt(30)/1715
            rounded(0.023217678f, 0.02321768120982215, 0x1.42p-56, 0x1.41c5614f9b80cp-56, 0x1p-113),
        },
    };
    static_assert(hvi::detail::symplectic(c, n), "the method is symplectic");

    // Slopes of the next step are about N times those of this one, and N_before times those of the
    // one before.
    static constexpr Scalar N[4][4] = {
        {
            Scalar(-2.0546788994731373), Scalar(2.7600938733523943),
            Scalar(-2.2332271794007466), Scalar(2.809173163222578),
        },
        {
            Scalar(-40.37571180266715), Scalar(47.53929456335511), Scalar(-31.27255601427564),
            Scalar(22.557059732673274),
        },
        {
            Scalar(-255.0938722066432), Scalar(273.2170291143525), Scalar(-158.21021607282424),
            Scalar(93.28587712846421),
        },
        {
            Scalar(-389.4401949819153), Scalar(398.27433382891263), Scalar(-218.02857114989172),
            Scalar(119.7540900668062),
        },
    };
    static constexpr Scalar N_before[4][4] = {
        {
            Scalar(0.20224718279206355), Scalar(-0.5393269303356351), Scalar(1.615453499688416),
            Scalar(-2.9619728082843713),
        },
        {
            Scalar(4.09705575042452), Scalar(-10.722511774735741), Scalar(30.950508433699323),
            Scalar(-52.8225956404637),
        },
        {
            Scalar(27.095185251041467), Scalar(-69.6419030256767), Scalar(194.38712000053582),
            Scalar(-312.89049875193206),
        },
        {
            Scalar(42.62487774239782), Scalar(-108.39391631791689), Scalar(296.857044476338),
            Scalar(-463.1803066899763),
        },
    };

    static constexpr hvi::detail::VelocityTable<Scalar, stages> cn_lanes{c, n};
    static constexpr auto N_lanes = hvi::detail::lane_columns(N);
    static constexpr auto N_before_lanes = hvi::detail::lane_columns(N_before);

    /// The real eigenvalues of C_ij = b_i n_ij, then pairs of complex ones, and the basis in which
    /// C is diagonal but for the pairs. Approximate.
    struct StageModes {
        static constexpr bool exist = true;
        static constexpr std::size_t real_ones = 0;
        static constexpr std::size_t pairs = 2;
        static constexpr Scalar real_parts[2] = {Scalar(-0.004993463692625386),
            Scalar(0.022850606549768244)};
        static constexpr Scalar imaginary_parts[2] = {Scalar(0.021181581225841524),
            Scalar(0.015032515974484127)};
        static constexpr Scalar to[4][4] = {
            {Scalar(4.372160721346074), Scalar(-2.454286740461806), Scalar(-0.22542572565700034),
            Scalar(0.2627649387741749)},
            {Scalar(-7.865249258907164), Scalar(-2.3629928652819516), Scalar(1.1342897419513656),
            Scalar(-0.360939595053997)},
            {Scalar(-4.372160721346074), Scalar(2.454286740461806), Scalar(0.22542572565700034),
            Scalar(0.7372350612258252)},
            {Scalar(29.07934128989778), Scalar(5.825967236481962), Scalar(0.8821384845016662),
            Scalar(-0.25615794074209763)},
        };
        static constexpr Scalar from[4][4] = {
            {Scalar(0.04924465427616796), Scalar(-0.0060340612292611034),
            Scalar(-0.012341759741363832), Scalar(0.023496918215603287)},
            {Scalar(-0.22936371070474926), Scalar(-0.07376693762435155),
            Scalar(0.053477941709661345), Scalar(0.022573888624952083)},
            {Scalar(0.18185500232064591), Scalar(0.6860944151266776), Scalar(0.34403605945794635),
            Scalar(0.20995610516110816)},
            {Scalar(1), Scalar(0), Scalar(1), Scalar(0)},
        };
    };

    using Corrections =
        hvi::detail::PositionCorrections<Vector, hvi::detail::HessianInTheMiddle, 4, StageModes>;

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

    /// The stage equations of Q_1, Q_2, Q_3, Q_4, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::VelocityLanes<Vector, 4>& s;
        Corrections& corrections;

        static constexpr hvi::detail::SolverCosts costs{62, 0, 174, 273};

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

        static constexpr std::size_t stages = 4;
        static constexpr Scalar coefficient(std::size_t j, std::size_t i) { return n[j][i]; }
        void force_at_start(Vector& out) const { system.dHdq(s.at.q, out); }
        template <class Matrix>
        void hessian_at_start(Matrix& out) const { system.d2Hdq2(s.at.q, out); }
        template <class Matrix>
        void hessian(std::size_t i, Matrix& out) const { system.d2Hdq2(s.position(i), out); }
    };

    System system_;
    hvi::detail::VelocityLanes<Vector, 4> s_;
    Corrections corrections_;
    typename Solver::template Iteration<Vector> solver_;
    decltype(s_.Lp) Lp_before_{};  // of the step before the last
    bool has_slopes_before_ = false;  // the last step went on from it
};

using Kepler = BasicKepler<double>;

}  // namespace hvi::generated
