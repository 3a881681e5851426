// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:3 mean_field.toml --unroll no --name MeanFieldGauss
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
//     the components of vectors are computed side by side: there are many of them
//     the slopes of the last two steps, extrapolated, are the starting values of the iteration: of
//         few stages, those of one step make a polynomial of low order
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
#include <hvi/detail/loops/chunks.hpp>
#include <hvi/detail/loops/stage_sweeps.hpp>

#include <cstddef>
#include <utility>

#include <hvi/detail/stages/velocity_stages.hpp>
#include <hvi/detail/stepper.hpp>
#include <hvi/fixed_point.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene mean-field of any size with gauss:3, computed in Number: float, double or long double.
/// States hold std::vector.
template <class Number>
class BasicMeanFieldGauss {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;

    /// As the scene has them.
    struct Parameters {
        Place N = 70;
    };

    /// H = sum(i=1..N,p[i]^2/2)-(sum(i=1..N,cos(q[i]))^2+sum(i=1..N,sin(q[i]))^2)/(2*N)
    struct System {
        using Scalar = Number;
        using Vector = std::vector<Number>;
        static constexpr bool has_diagonal_mass = true;

        explicit System(const Parameters& parameters, unsigned /*threads*/ = 1)
            : N_(parameters.N) {
            Place in_q = 0, in_p = 0;
            q_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            p_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            size_ = static_cast<std::size_t>(in_q);
            c1_ = Scalar(1.0) / static_cast<Scalar>(parameters.N);
        }

        /// sum(i=1..N,cos(q[i]))
        [[nodiscard]] Scalar total_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const
            Scalar* p, [[maybe_unused]] const Scalar* totals) const {
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(q + q_at_ + (i));
                    inner.add(V(hvi::math::cos(a1)));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        /// sum(i=1..N,sin(q[i]))
        [[nodiscard]] Scalar total_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const
            Scalar* p, [[maybe_unused]] const Scalar* totals) const {
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(q + q_at_ + (i));
                    inner.add(V(hvi::math::sin(a1)));
                });
                total.add(inner.sum());
            }
            return total.sum();
        }

        /// Degrees of freedom.
        [[nodiscard]] std::size_t size() const { return size_; }

        /// Whether vectors have the size of the system, and all that sums look at is there: lists
        /// may be too short.
        [[nodiscard]] bool fits(const Vector& q, const Vector& p) const {
            return fits_ && q.size() == size_ && p.size() == size_;
        }

        void add_by_q_3([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, const
            Scalar* totals, Scalar* out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                hvi::detail::subtract(out + q_at_ + (i), V(totals[1] * c1_ * hvi::math::cos(a1)));
            });
        }

        void add_by_q_4([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, const
            Scalar* totals, Scalar* out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                hvi::detail::add(out + q_at_ + (i), V(totals[0] * c1_ * hvi::math::sin(a1)));
            });
        }

        void dHdq([[maybe_unused]] const Vector& q, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            Scalar totals[2] = {};
            totals[0] = total_1(q.data(), nullptr, totals);
            totals[1] = total_2(q.data(), nullptr, totals);
            add_by_q_3(q.data(), nullptr, totals, out.data(), 1, N_ + 1);
            add_by_q_4(q.data(), nullptr, totals, out.data(), 1, N_ + 1);
        }

        void add_by_p_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(p + p_at_ + (i));
                hvi::detail::add(out + p_at_ + (i), V(a1));
            });
        }

        void dHdp([[maybe_unused]] const Vector& p, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_p_1(nullptr, p.data(), out.data(), 1, N_ + 1);
        }

        /// d2H/dp2 v, which is constant.
        void inverse_mass(const Vector& v, Vector& out) const { dHdp(v, out); }

        /// Lp_j = -h b_j dH/dq(Q_j) and W_j = h d2H/dp2 Lp_j.
        template <class Stages>
        void kick_stage(Stages& s, std::size_t j) const {
            dHdq(s.Q[j], s.Lp[j]);
            hvi::detail::scale(s.Lp[j], -s.hb[j]);
            s.drift(*this, j);
        }

        [[nodiscard]] Scalar energy([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            Scalar totals[2] = {};
            totals[0] = total_1(q, p, totals);
            totals[1] = total_2(q, p, totals);
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
                total.add(-Scalar(0.5) * (totals[0] * totals[0] * c1_
                    + totals[1] * totals[1] * c1_));
            }
            return total.sum();
        }

        [[nodiscard]] Scalar P([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const Vector&
            p_of) const {
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
                    inner.add(V(a1));
                });
                total.add(inner.sum());
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
                q[q_at_ + i] = hvi::math::sin(static_cast<Scalar>(i));
            }
            for (Place i = 1; i <= N_; ++i) {
                p[p_at_
                    + i] = Scalar(1) / Scalar(3) * hvi::math::cos(Scalar(2.0) *
                    static_cast<Scalar>(i));
            }
        }

        Scalar c1_ = 0;
        Place N_;
        Place q_at_ = 0;
        Place p_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
    };

    using Solver = hvi::FixedPoint;

    using State = hvi::State<Vector>;

    BasicMeanFieldGauss() : BasicMeanFieldGauss(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicMeanFieldGauss(const Parameters& parameters, unsigned threads = 1) :
        system_(parameters, threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H = sum(i=1..N,p[i]^2/2)-(sum(i=1..N,cos(q[i]))^2+sum(i=1..N,sin(q[i]))^2)/(2*N); not a
    /// number where x does not have the system's size
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p);
    }

    /// sum(i=1..N,p[i]); not a number where x does not have the system's size
    [[nodiscard]] Scalar P(const State& x) const {
        return system_.P(x.q, x.p);
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

    /// Starting values: the polynomial through the forces of the last two steps, else forces as at
    /// the start of this one.
    void predict() {
        if (s_.goes_on && has_slopes_before_) {
            for (Index k = 0; k < s_.at.q.size(); ++k) {
                const Scalar W_1 = s_.W[0][k];
                const Scalar W_2 = s_.W[1][k];
                const Scalar W_3 = s_.W[2][k];
                const Scalar W_before_1 = W_before_[0][k];
                const Scalar W_before_2 = W_before_[1][k];
                const Scalar W_before_3 = W_before_[2][k];
                W_before_[0][k] = W_1;
                W_before_[1][k] = W_2;
                W_before_[2][k] = W_3;
                s_.W[0][k] = N[0][0] * W_1 + N[0][1] * W_2 + N[0][2] * W_3
                    + N_before[0][0] * W_before_1 + N_before[0][1] * W_before_2
                    + N_before[0][2] * W_before_3;
                s_.W[1][k] = N[1][0] * W_1 + N[1][1] * W_2 + N[1][2] * W_3
                    + N_before[1][0] * W_before_1 + N_before[1][1] * W_before_2
                    + N_before[1][2] * W_before_3;
                s_.W[2][k] = N[2][0] * W_1 + N[2][1] * W_2 + N[2][2] * W_3
                    + N_before[2][0] * W_before_1 + N_before[2][1] * W_before_2
                    + N_before[2][2] * W_before_3;
            }
            return;
        }
        has_slopes_before_ = s_.goes_on;
        W_before_ = s_.W;
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
    };

    System system_;
    hvi::detail::VelocityStages<Vector, stages> s_;
    typename Solver::template Iteration<Vector> solver_;
    decltype(s_.W) W_before_{};  // of the step before the last
    bool has_slopes_before_ = false;  // the last step went on from it
};

using MeanFieldGauss = BasicMeanFieldGauss<double>;

}  // namespace hvi::generated
