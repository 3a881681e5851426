// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:3 springs.toml --unroll no --name Springs3
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
// Choices:
//
//     the momenta of the stages are eliminated: the kinetic energy is quadratic: the stages are
//         solved for their positions alone
//     Newton's method, which keeps its factors while h stays: H is quadratic: the equations are
//         linear
//     the equations of Newton's method decouple: 1 real eigenvalue of A A~ and 1 pair: at the start
//         of a step all stages have the same second derivatives
//     the components of vectors are computed side by side: there are many of them
//     the last step's slopes, extrapolated, are the starting values of the iteration: they are good
//         to the order of the interpolation and cost no evaluation
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <hvi/detail/coefficients/rounded.hpp>
#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/loops/along.hpp>
#include <hvi/detail/loops/ranges.hpp>
#include <hvi/detail/loops/sites.hpp>
#include <hvi/detail/loops/stage_sweeps.hpp>

#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/newton_chains.hpp>
#include <hvi/detail/stages/velocity_stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene springs of any size with gauss:3, computed in Number: float, double or long double.
/// States hold std::vector.
template <class Number>
class BasicSprings3 {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;

    /// As the scene has them.
    struct Parameters {
        Place N = 70;
        Scalar k = Scalar(100.0);  // k = 100
    };

    /// H = sum(i=1..N,p[i]^2)/2+k*(sum(i=1..N-1,(x[i+1]-x[i])^2)+x[1]^2+x[N]^2)/2
    struct System {
        using Scalar = Number;
        using Vector = std::vector<Number>;
        static constexpr std::size_t dimension = 1;  // indices of a site
        static constexpr std::size_t components = 1;
        using Site = hvi::detail::Site<dimension>;
        static constexpr Site reach = {{1}};
        static constexpr bool has_diagonal_mass = true;

        explicit System(const Parameters& parameters, unsigned /*threads*/ = 1)
            : N_(parameters.N) {
            Place in_q = 0, in_p = 0;
            x_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            p_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            size_ = static_cast<std::size_t>(in_q);
            count_ = in_q / 1;
            fits_ = fits_ && 1 <= N_;
            c1_ = parameters.k;
        }

        /// Degrees of freedom.
        [[nodiscard]] std::size_t size() const { return size_; }

        /// Whether vectors have the size of the system, and all that sums look at is there: lists
        /// may be too short.
        [[nodiscard]] bool fits(const Vector& q, const Vector& p) const {
            return fits_ && q.size() == size_ && p.size() == size_;
        }

        [[nodiscard]] hvi::detail::Sites<dimension> sites() const {
            return {{{{1}}, {{std::max<Place>(1, N_ + 1)}}},
                    {{{std::max<Place>({1, 2, 2})}}, {{std::min<Place>({N_ + 1, N_, N_})}}}};
        }

        /// dU/dq of the sites e, e + 1, ... that V stands for, where all their neighbours are; the
        /// first has the indices k.
        template <class V>
        HVI_INLINE_IN_LANES void force([[maybe_unused]] const Scalar* q, [[maybe_unused]] Place e,
            [[maybe_unused]] const Site& k, V (&out)[components]) const {
            const V a1 = hvi::detail::Stretch<V>::load(q + (e));
            const V a2 = hvi::detail::Stretch<V>::load(q + (e - 1));
            const V a3 = hvi::detail::Stretch<V>::load(q + (e + 1));
            out[0] = V(c1_ * (a1 - a2 + (a1 - a3)));
        }

        /// Force on any site.
        void force_at_edge([[maybe_unused]] const Scalar* q, Place, [[maybe_unused]] const Site& k,
            Scalar (&out)[components]) const {
            for (Scalar& each : out) { each = 0; }
            {
                const Place i = k[0] - (1);
                if (1 <= i && i <= N_ - 1) {
                    const Scalar a1 = q[x_at_ + (i + 1)];
                    const Scalar a2 = q[x_at_ + (i)];
                    out[0] += c1_ * (a1 - a2);
                }
            }
            {
                const Place i = k[0] - (0);
                if (1 <= i && i <= N_ - 1) {
                    const Scalar a1 = q[x_at_ + (i + 1)];
                    const Scalar a2 = q[x_at_ + (i)];
                    out[0] += -c1_ * (a1 - a2);
                }
            }
            {
                if (k[0] == 1) {
                    const Scalar a1 = q[x_at_ + (1)];
                    out[0] += c1_ * a1;
                }
            }
            {
                if (k[0] == N_) {
                    const Scalar a1 = q[x_at_ + (N_)];
                    out[0] += c1_ * a1;
                }
            }
        }

        /// dT/dp of sites with the momenta p.
        template <class V>
        HVI_INLINE_IN_LANES void velocity([[maybe_unused]] const V (&p)[components],
            [[maybe_unused]] Place e, [[maybe_unused]] const Site& k, V (&out)[components]) const {
            out[0] = V(p[0]);
        }

        void dHdq(const Vector& q, Vector& out) const {
            hvi::detail::gather(*this, q.data(), out.data());
        }

        void dHdp(const Vector& p, Vector& out) const {
            hvi::detail::velocities(*this, p.data(), out.data());
        }

        /// d2H/dp2 v, which is constant.
        void inverse_mass(const Vector& v, Vector& out) const { dHdp(v, out); }

        /// Lp_j = -h b_j dH/dq(Q_j) and W_j = h d2H/dp2 Lp_j.
        template <class Stages>
        void kick_stage(Stages& s, std::size_t j) const {
            hvi::detail::kick_stage(*this, s, j);
        }

        /// Adds the entries i, j of d2H/dq2 by out.add(i, j, value).
        template <class Matrix>
        void d2Hdq2([[maybe_unused]] const Vector& q_of, [[maybe_unused]] Matrix& out) const {
            [[maybe_unused]] const Scalar* const q = q_of.data();
            for (Place i = 1; i <= N_ - 1; ++i) {
                out.add(x_at_ + (i + 1), x_at_ + (i + 1), Scalar(c1_));
                out.add(x_at_ + (i + 1), x_at_ + (i), Scalar(-c1_));
                out.add(x_at_ + (i), x_at_ + (i + 1), Scalar(-c1_));
                out.add(x_at_ + (i), x_at_ + (i), Scalar(c1_));
            }
            {
                out.add(x_at_ + (1), x_at_ + (1), Scalar(c1_));
                out.add(x_at_ + (N_), x_at_ + (N_), Scalar(c1_));
            }
        }

        [[nodiscard]] Scalar energy([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + p_at_ + (i));
                    inner.add(V(Scalar(0.5) * (a1 * a1)));
                });
                total.add(inner.sum());
            }
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_, [&](auto stretch, [[maybe_unused]] Place i)
                    HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(q + x_at_ + (i + 1));
                    const V a2 = stretch.load(q + x_at_ + (i));
                    const V t1 = a1 - a2;
                    inner.add(V(Scalar(0.5) * (t1 * t1 * c1_)));
                });
                total.add(inner.sum());
            }
            {
                const Scalar a1 = q[x_at_ + (1)];
                const Scalar a2 = q[x_at_ + (N_)];
                total.add(Scalar(0.5) * (a1 * a1 * c1_ + a2 * a2 * c1_));
            }
            return total.sum();
        }

        /// Where the scene begins; empty where lists do not fit.
        void begin(Vector& q_of, Vector& p_of) const {
            q_of.clear();
            p_of.clear();
            q_of.assign(size_, Scalar(0));
            [[maybe_unused]] Scalar* const q = q_of.data();
            p_of.assign(size_, Scalar(0));
            [[maybe_unused]] Scalar* const p = p_of.data();
            for (Place i = 1; i <= N_; ++i) {
                q[x_at_ + i] = hvi::math::sin(static_cast<Scalar>(i));
            }
            for (Place i = 1; i <= N_; ++i) {
                p[p_at_ + i] = Scalar(0.0);
            }
        }

        Scalar c1_ = 0;
        Place N_;
        Place x_at_ = 0;
        Place p_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
        Place count_ = 0;  // of sites
    };

    using Solver = hvi::NewtonOfChains;

    using State = hvi::State<Vector>;

    BasicSprings3() : BasicSprings3(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicSprings3(const Parameters& parameters, unsigned threads = 1) : system_(parameters,
        threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H = sum(i=1..N,p[i]^2)/2+k*(sum(i=1..N-1,(x[i+1]-x[i])^2)+x[1]^2+x[N]^2)/2; not a number
    /// where x does not have the system's size
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p);
    }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (!system_.fits(x.q, x.p)) { return Status(Status::Code::dimension_mismatch); }
        if (h == 0) { return {}; }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        s_.weigh(system_, b);
        s_.drift_freely(system_, c);
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, s_});
        if (!status.ok()) { return status; }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.end_q(k, (1 - c[0]) * s_.W[0][k] + (1 - c[1]) * s_.W[1][k] + (1
                - c[2]) * s_.W[2][k]);
        }
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

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[3][3] = {
        {
            Scalar(0.46034998712591646), Scalar(-0.9391805448271526),
            Scalar(2.0423388845975277),
        },
        {
            Scalar(3.2677422153560443), Scalar(-5.666666666666667), Scalar(7.398924451310623),
        },
        {
            Scalar(4.624327782069139), Scalar(-7.39415278850618), Scalar(8.20631667954075),
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
                s_.W[0][k] = N[0][0] * W_1 + N[0][1] * W_2 + N[0][2] * W_3;
                s_.W[1][k] = N[1][0] * W_1 + N[1][1] * W_2 + N[1][2] * W_3;
                s_.W[2][k] = N[2][0] * W_1 + N[2][1] * W_2 + N[2][2] * W_3;
            }
            return;
        }
        system_.dHdq(s_.at.q, s_.slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.hb[0] * s_.slope[k];
        }
        s_.drift(system_, 0);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[1][k] = -s_.hb[1] * s_.slope[k];
        }
        s_.drift(system_, 1);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[2][k] = -s_.hb[2] * s_.slope[k];
        }
        s_.drift(system_, 2);
    }

    /// The stage equations of Q_1, Q_2, Q_3, which are solved at once.
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
            hvi::detail::move_stages(s, n, std::array<std::size_t, 3>{{0, 1, 2}});
        }

        /// Lp_i = -h b_i dH/dq, W_i = h K Lp_i.
        void forces() {
            system.kick_stage(s, 0);
            system.kick_stage(s, 1);
            system.kick_stage(s, 2);
        }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q(Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.free_path[k])
                + hvi::detail::abs(s.Q[0][k]) + hvi::detail::abs(s.Q[1][k])
                + hvi::detail::abs(s.Q[2][k]) + hvi::detail::abs(s.W[0][k])
                + hvi::detail::abs(s.W[1][k]) + hvi::detail::abs(s.W[2][k]);
        }

        static constexpr std::array<std::size_t, 3> unknown{0, 1, 2};
        static constexpr Scalar coefficient(std::size_t i, std::size_t j) { return n[i][j]; }
        /// The real eigenvalues of C_ij = b_i n_ij, then pairs of complex ones, and the basis in
        /// which C is diagonal but for the pairs. Approximate.
        struct Modes {
            static constexpr bool exist = true;
            static constexpr std::size_t real_ones = 1;
            static constexpr std::size_t pairs = 1;
            static constexpr Scalar real_parts[2] = {Scalar(0.046360300801824184),
                Scalar(0.0018198495990879087)};
            static constexpr Scalar imaginary_parts[1] = {Scalar(0.038660280191014876)};
            static constexpr Scalar to[3][3] = {
                {Scalar(5.991698084937801), Scalar(0.7120089344723346),
                Scalar(0.43231211378385836)},
                {Scalar(-5.991698084937801), Scalar(-0.7120089344723346),
                Scalar(0.5676878862161416)},
                {Scalar(-1.2462132735862315), Scalar(1.828474778870196),
                Scalar(-0.25773520127343247)},
            };
            static constexpr Scalar from[3][3] = {
                {Scalar(0.07215185205520017), Scalar(-0.08224123057363067),
                Scalar(-0.0601207386193085)},
                {Scalar(0.19013212598604448), Scalar(0.08490414518729823),
                Scalar(0.5059280818116665)},
                {Scalar(1), Scalar(1), Scalar(0)},
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
};

using Springs3 = BasicSprings3<double>;

}  // namespace hvi::generated
