// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:2 all_pairs.toml --solver newton --unroll no --name AllPairs
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
// Choices:
//
//     the momenta of the stages are eliminated: the kinetic energy is quadratic: the stages are
//         solved for their positions alone
//     the equations of Newton's method decouple: 0 real eigenvalues of A A~ and 1 pair: at the
//         start of a step all stages have the same second derivatives
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
#include <hvi/detail/loops/chunks.hpp>
#include <hvi/detail/loops/stage_sweeps.hpp>

#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/newton_products.hpp>
#include <hvi/detail/stages/velocity_stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene all-pairs of any size with gauss:2, computed in Number: float, double or long double.
/// States hold std::vector.
template <class Number>
class BasicAllPairs {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;

    /// As the scene has them.
    struct Parameters {
        Place N = 70;
        Scalar k = Scalar(2.0);  // k = 2
    };

    /// H = sum(i=1..N,p[i]^2/2)+k*sum(i=1..N,sum(j=i+1..N,(x[i]-x[j])^2))/2
    struct System {
        using Scalar = Number;
        using Vector = std::vector<Number>;
        static constexpr bool has_diagonal_mass = true;

        explicit System(const Parameters& parameters, unsigned threads = 1)
            : N_(parameters.N), team_(threads) {
            Place in_q = 0, in_p = 0;
            x_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            p_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            size_ = static_cast<std::size_t>(in_q);
            c1_ = parameters.k;
        }

        /// Degrees of freedom.
        [[nodiscard]] std::size_t size() const { return size_; }

        /// Whether vectors have the size of the system, and all that sums look at is there: lists
        /// may be too short.
        [[nodiscard]] bool fits(const Vector& q, const Vector& p) const {
            return fits_ && q.size() == size_ && p.size() == size_;
        }

        void add_by_q_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to, Place stride) const {
            for (Place i = from; i < to; i += stride) {
                hvi::detail::Total<Scalar, 8> sum_1;
                const Scalar a1 = q[x_at_ + (i)];
                hvi::detail::along<Scalar, 8>(i + 1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place j) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a2 = stretch.load(q + x_at_ + (j));
                    const V t1 = c1_ * (a1 - a2);
                    sum_1.add(V(t1));
                    hvi::detail::subtract(out + x_at_ + (j), V(t1));
                });
                out[x_at_ + (i)] += sum_1.sum();
            }
        }

        void dHdq([[maybe_unused]] const Vector& q, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            hvi::detail::chunked(team_, 1, N_ + 1, out.data(), out.size(), memory_,
                [&](Place from, Place to, Place stride, Scalar* to_out) {
                add_by_q_2(q.data(), nullptr, to_out, from, to, stride);
            });
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

        void add_product_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* way,
            Scalar* out, Place from, Place to, Place stride) const {
            for (Place i = from; i < to; i += stride) {
                hvi::detail::Total<Scalar, 8> sum_1;
                const Scalar a1 = way[x_at_ + (i)];
                hvi::detail::along<Scalar, 8>(i + 1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place j) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a2 = stretch.load(way + x_at_ + (j));
                    const V t1 = c1_ * (a1 - a2);
                    sum_1.add(V(t1));
                    hvi::detail::subtract(out + x_at_ + (j), V(t1));
                });
                out[x_at_ + (i)] += sum_1.sum();
            }
        }

        /// out = d2H/dq2 way.
        void d2Hdq2([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& way, Vector&
            out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            hvi::detail::chunked(team_, 1, N_ + 1, out.data(), out.size(), memory_,
                [&](Place from, Place to, Place stride, Scalar* to_out) {
                add_product_1(q.data(), way.data(), to_out, from, to, stride);
            });
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
            for (Place i = 1; i <= N_; ++i) {
                hvi::detail::Total<Scalar, 8> inner;
                const Scalar a1 = q[x_at_ + (i)];
                hvi::detail::along<Scalar, 8>(i + 1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place j) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a2 = stretch.load(q + x_at_ + (j));
                    const V t1 = a1 - a2;
                    inner.add(V(Scalar(0.5) * (t1 * t1 * c1_)));
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
                q[x_at_ + i] = hvi::math::sin(static_cast<Scalar>(i));
            }
            for (Place i = 1; i <= N_; ++i) {
                p[p_at_ + i] = hvi::math::cos(Scalar(3.0) * static_cast<Scalar>(i));
            }
        }

        Scalar c1_ = 0;
        Place N_;
        Place x_at_ = 0;
        Place p_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
        mutable hvi::detail::Team team_;
        mutable Vector memory_{};  // of chunks
    };

    using Solver = hvi::NewtonOfProducts;

    using State = hvi::State<Vector>;

    BasicAllPairs() : BasicAllPairs(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicAllPairs(const Parameters& parameters, unsigned threads = 1) : system_(parameters,
        threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H = sum(i=1..N,p[i]^2/2)+k*sum(i=1..N,sum(j=i+1..N,(x[i]-x[j])^2))/2; not a number where x
    /// does not have the system's size
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
            s_.end_q(k, (1 - c[0]) * s_.W[0][k] + (1 - c[1]) * s_.W[1][k]);
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

    static constexpr std::size_t stages = 2;

    static constexpr Scalar b[2] = {
        Scalar(0.5),  // b_1 = 1/2
        Scalar(0.5),  // b_2 = 1/2
    };

    // The momenta are eliminated: n_ij = sum_k a_ik a~_kj/b_j, rounded with c so that n_ij - n_ji
    // is c_i - c_j exactly.
    static constexpr Scalar c[2] = {
        // c_1 = 1/2-sqrt(3)/6
        rounded(0.21132487f, 0.21132486540518713, -0x1.35p-56, -0x1.34863e0792becp-56, -0x1.3p-109),
        // c_2 = 1/2+sqrt(3)/6
        rounded(0.7886751f, 0.7886751345948129, 0x1.35p-56, 0x1.34863e0792becp-56, 0x1.3p-109),
    };
    static constexpr Scalar n[2][2] = {
        {
            // n_1,1 = 1/12
            rounded(0.08333331f, 0.08333333333333337, -0x1.558p-55, -0x1.5555555555555p-55,
                -0x1.5p-109),
            // n_1,2 = 1/4-sqrt(3)/6
            rounded(-0.03867513f, -0.038675134594812866, -0x1.35p-56, -0x1.34863e0792becp-56,
                -0x1.3p-109),
        },
        {
            // n_2,1 = 1/4+sqrt(3)/6
            rounded(0.5386751f, 0.5386751345948129, 0x1.35p-56, 0x1.34863e0792becp-56, 0x1.3p-109),
            // n_2,2 = 1/12
            rounded(0.08333331f, 0.08333333333333337, -0x1.558p-55, -0x1.5555555555555p-55,
                -0x1.5p-109),
        },
    };
    static_assert(hvi::detail::symplectic(c, n), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[2][2] = {
        {
            Scalar(-0.7320508075688773), Scalar(1.7320508075688772),
        },
        {
            Scalar(-1.7320508075688772), Scalar(2.732050807568877),
        },
    };

    /// Starting values: the polynomial through the forces of the last step, else forces as at the
    /// start of this one.
    void predict() {
        if (s_.goes_on) {
            for (Index k = 0; k < s_.at.q.size(); ++k) {
                const Scalar W_1 = s_.W[0][k];
                const Scalar W_2 = s_.W[1][k];
                s_.W[0][k] = N[0][0] * W_1 + N[0][1] * W_2;
                s_.W[1][k] = N[1][0] * W_1 + N[1][1] * W_2;
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
    }

    /// The stage equations of Q_1, Q_2, which are solved at once.
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
            hvi::detail::move_stages(s, n, std::array<std::size_t, 2>{{0, 1}});
        }

        /// Lp_i = -h b_i dH/dq, W_i = h K Lp_i.
        void forces() {
            system.kick_stage(s, 0);
            system.kick_stage(s, 1);
        }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q(Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.free_path[k])
                + hvi::detail::abs(s.Q[0][k]) + hvi::detail::abs(s.Q[1][k])
                + hvi::detail::abs(s.W[0][k]) + hvi::detail::abs(s.W[1][k]);
        }

        static constexpr std::array<std::size_t, 2> unknown{0, 1};
        static constexpr Scalar coefficient(std::size_t i, std::size_t j) { return n[i][j]; }
        /// The real eigenvalues of C_ij = b_i n_ij, then pairs of complex ones, and the basis in
        /// which C is diagonal but for the pairs. Approximate.
        struct Modes {
            static constexpr bool exist = true;
            static constexpr std::size_t real_ones = 0;
            static constexpr std::size_t pairs = 1;
            static constexpr Scalar real_parts[1] = {Scalar(0.041666666666666664)};
            static constexpr Scalar imaginary_parts[1] = {Scalar(0.07216878364870322)};
            static constexpr Scalar to[2][2] = {
                {Scalar(0), Scalar(1)},
                {Scalar(3.732050807568877), Scalar(0)},
            };
            static constexpr Scalar from[2][2] = {
                {Scalar(0), Scalar(0.2679491924311227)},
                {Scalar(1), Scalar(0)},
            };
        };

        /// W_j = h K Lp_j.
        void drifts() {
            for (const std::size_t j : unknown) {
                s.drift(system, j);
            }
        }

        void force_at_start(Vector& out) const { system.dHdq(s.at.q, out); }
        /// d2H/dq2 at Q, times v, at the start of the step, and of stage i.
        void hessian_at_start_times(const Vector& Q, const Vector& v, Vector& out) const {
            system.d2Hdq2(Q, v, out); }
        void hessian_times([[maybe_unused]] std::size_t i, const Vector& Q, const Vector& v, Vector&
            out) const {
            system.d2Hdq2(Q, v, out);
        }
    };

    System system_;
    hvi::detail::VelocityStages<Vector, stages> s_;
    typename Solver::template Iteration<Vector> solver_;
};

using AllPairs = BasicAllPairs<double>;

}  // namespace hvi::generated
