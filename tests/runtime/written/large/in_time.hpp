// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:2 sites_in_time.toml --unroll no --dense --action --name InTime
// SPDX-License-Identifier: MIT
//
// gauss:2: symplectic, 2 stages, for general Hamiltonians.
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
//     the state has a time: H depends on it
//     the stages keep their momenta, and are computed one by one: the action is summed over
//         positions, momenta and slopes
//     fixed points, and Newton's method for steps on which they are slow: how stiff H is depends on
//         h and on the state
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

#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/automatic.hpp>
#include <hvi/detail/solvers/newton_pair_products.hpp>
#include <hvi/detail/stages/action.hpp>
#include <hvi/detail/stages/clock.hpp>
#include <hvi/detail/stages/curve.hpp>
#include <hvi/detail/stages/stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene sites-in-time of any size with gauss:2, computed in Number: float, double or long
/// double. States hold std::vector.
template <class Number>
class BasicInTime {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;

    /// As the scene has them.
    struct Parameters {
        Place N = 5;
    };

    /// H =
    /// sum(i=1..N,(1+cos(t)/3)*(q[i]^2+p[i]^2)^2/8+(q[i]^2+p[i]^2)/2)-sum(i=1..N,q[i]*q[mod(i,N)+1]
    /// +p[i]*p[mod(i,N)+1])
    struct System {
        using Scalar = Number;
        using Vector = std::vector<Number>;

        explicit System(const Parameters& parameters, unsigned /*threads*/ = 1)
            : N_(parameters.N) {
            Place in_q = 0, in_p = 0;
            q_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            p_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            size_ = static_cast<std::size_t>(in_q);
        }

        /// Degrees of freedom.
        [[nodiscard]] std::size_t size() const { return size_; }

        /// Whether vectors have the size of the system, and all that sums look at is there: lists
        /// may be too short.
        [[nodiscard]] bool fits(const Vector& q, const Vector& p) const {
            return fits_ && q.size() == size_ && p.size() == size_;
        }

        void add_by_q_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                const V t1 = (Scalar(1.0) + Scalar(1) / Scalar(3) * hvi::math::cos(t)) * (a1 * a1
                    + a2 * a2);
                hvi::detail::add(out + q_at_ + (i), V(Scalar(0.5) * t1 * a1));
            });
        }

        void add_by_q_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            for (Place i = from; i < to; ++i) {
                const Scalar a1 = q[q_at_ + (i)];
                const Scalar a2 = q[q_at_ + (hvi::detail::remainder(i, N_) + (1))];
                out[q_at_ + (i)] += a1 - a2;
                out[q_at_ + (hvi::detail::remainder(i, N_) + (1))] += -a1;
            }
        }

        void dHdq([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] Scalar t, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_q_1(q.data(), p.data(), t, out.data(), 1, N_ + 1);
            add_by_q_2(q.data(), p.data(), t, out.data(), 1, N_ + 1);
        }

        void add_by_p_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                const V t1 = (Scalar(1.0) + Scalar(1) / Scalar(3) * hvi::math::cos(t)) * (a1 * a1
                    + a2 * a2);
                hvi::detail::add(out + p_at_ + (i), V(Scalar(0.5) * t1 * a2));
            });
        }

        void add_by_p_3([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            for (Place i = from; i < to; ++i) {
                const Scalar a1 = p[p_at_ + (i)];
                const Scalar a2 = p[p_at_ + (hvi::detail::remainder(i, N_) + (1))];
                out[p_at_ + (i)] += a1 - a2;
                out[p_at_ + (hvi::detail::remainder(i, N_) + (1))] += -a1;
            }
        }

        void dHdp([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] Scalar t, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_p_1(q.data(), p.data(), t, out.data(), 1, N_ + 1);
            add_by_p_3(q.data(), p.data(), t, out.data(), 1, N_ + 1);
        }

        void add_product_by_q_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                const V a3 = stretch.load(way + q_at_ + (i));
                const V a4 = stretch.load(way_p + p_at_ + (i));
                const V t1 = Scalar(1.0) + Scalar(1) / Scalar(3) * hvi::math::cos(t);
                const V t2 = Scalar(0.5) * (t1 * (a1 * a1 + a2 * a2)) * a3 + t1 * (a2 * a4
                    + a1 * a3) * a1;
                hvi::detail::add(out + q_at_ + (i), V(t2));
            });
        }

        void add_product_by_q_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            for (Place i = from; i < to; ++i) {
                const Scalar a1 = way[q_at_ + (i)];
                const Scalar a2 = way[q_at_ + (hvi::detail::remainder(i, N_) + (1))];
                out[q_at_ + (i)] += a1 - a2;
                out[q_at_ + (hvi::detail::remainder(i, N_) + (1))] += -a1;
            }
        }

        /// Rows by q of d2H times a vector: way of positions, way_p of momenta.
        void d2Hdq([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] const Vector& way, [[maybe_unused]] const Vector& way_p,
            [[maybe_unused]] Scalar t, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_product_by_q_1(q.data(), p.data(), way.data(), way_p.data(), t, out.data(), 1, N_
                + 1);
            add_product_by_q_2(q.data(), p.data(), way.data(), way_p.data(), t, out.data(), 1, N_
                + 1);
        }

        void add_product_by_p_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                const V a3 = stretch.load(way + q_at_ + (i));
                const V a4 = stretch.load(way_p + p_at_ + (i));
                const V t1 = Scalar(1.0) + Scalar(1) / Scalar(3) * hvi::math::cos(t);
                const V t2 = t1 * (Scalar(0.5) * (a1 * a1) + Scalar(1.5) * (a2 * a2)) * a4;
                hvi::detail::add(out + p_at_ + (i), V(a1 * a3 * t1 * a2 + t2));
            });
        }

        void add_product_by_p_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            for (Place i = from; i < to; ++i) {
                const Scalar a1 = way_p[p_at_ + (i)];
                const Scalar a2 = way_p[p_at_ + (hvi::detail::remainder(i, N_) + (1))];
                out[p_at_ + (i)] += a1 - a2;
                out[p_at_ + (hvi::detail::remainder(i, N_) + (1))] += -a1;
            }
        }

        /// Rows by p of d2H times a vector: way of positions, way_p of momenta.
        void d2Hdp([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] const Vector& way, [[maybe_unused]] const Vector& way_p,
            [[maybe_unused]] Scalar t, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_product_by_p_1(q.data(), p.data(), way.data(), way_p.data(), t, out.data(), 1, N_
                + 1);
            add_product_by_p_2(q.data(), p.data(), way.data(), way_p.data(), t, out.data(), 1, N_
                + 1);
        }

        [[nodiscard]] Scalar energy([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of, [[maybe_unused]] Scalar t) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(q + q_at_ + (i));
                    const V a2 = stretch.load(p + p_at_ + (i));
                    const V t1 = a1 * a1 + a2 * a2;
                    const V t2 = t1 * t1 * (Scalar(1.0)
                        + Scalar(1) / Scalar(3) * hvi::math::cos(t));
                    inner.add(V(Scalar(0.125) * t2));
                });
                total.add(inner.sum());
            }
            for (Place i = 1; i <= N_; ++i) {
                const Scalar a1 = q[q_at_ + (i)];
                const Scalar a2 = q[q_at_ + (hvi::detail::remainder(i, N_) + (1))];
                total.add(Scalar(0.5) * (a1 * a1) - a1 * a2);
            }
            for (Place i = 1; i <= N_; ++i) {
                const Scalar a1 = p[p_at_ + (i)];
                const Scalar a2 = p[p_at_ + (hvi::detail::remainder(i, N_) + (1))];
                total.add(Scalar(0.5) * (a1 * a1) - a1 * a2);
            }
            return total.sum();
        }

        [[nodiscard]] Scalar norm([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
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
                    const V a1 = stretch.load(q + q_at_ + (i));
                    inner.add(V(a1 * a1));
                });
                total.add(inner.sum());
            }
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_
                    + 1, [&](auto stretch, [[maybe_unused]] Place i) HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + p_at_ + (i));
                    inner.add(V(a1 * a1));
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
                p[p_at_ + i] = hvi::math::cos(Scalar(2.0) * static_cast<Scalar>(i));
            }
        }

        Place N_;
        Place q_at_ = 0;
        Place p_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
    };

    using Solver = hvi::Automatic<hvi::NewtonOfPairProducts>;

    using State = hvi::TimedState<Vector>;

    BasicInTime() : BasicInTime(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicInTime(const Parameters& parameters, unsigned threads = 1) : system_(parameters,
        threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H =
    /// sum(i=1..N,(1+cos(t)/3)*(q[i]^2+p[i]^2)^2/8+(q[i]^2+p[i]^2)/2)-sum(i=1..N,q[i]*q[mod(i,N)+1]
    /// +p[i]*p[mod(i,N)+1]); not a number where x does not have the system's size
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p, x.t);
    }

    /// sum(i=1..N,q[i]^2+p[i]^2); not a number where x does not have the system's size
    [[nodiscard]] Scalar norm(const State& x) const {
        return system_.norm(x.q, x.p);
    }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (!system_.fits(x.q, x.p)) { return Status(Status::Code::dimension_mismatch); }
        if (h == 0) { return {}; }
        if (!clock_.begin(x.t, h, c)) { s_.forget(); }
        if (!clock_.ends()) { return Status(Status::Code::not_finite); }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, clock_, s_});
        if (!status.ok()) { return status; }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k] + s_.Lq[1][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k] + s_.Lp[1][k]);
        }
        action_.begin(x, integral_over_step(x));
        return action_.end(x, clock_.end(x.t, s_.end(x, status.iterations)));
    }

    /// The position q_d(tau h) within the last step, on the curve of the method (Section 4.1 of the
    /// paper): where the step began at tau = 0, where it ended at 1. From the exact solution
    /// through its beginning it is O(h^3) away for all tau in [0, 1]. A step of size 0, or of one
    /// that is not finite, leaves the curve of the one before. After any other step that failed,
    /// after reset() and before any step the position is NaN.
    [[nodiscard]] Vector position(Scalar tau) const {
        if (!s_.has_ended()) { return hvi::detail::nowhere(Vector(system_.size())); }
        const auto bend = hvi::detail::departures(curve, tau);
        Vector q = s_.at.q;
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            const Scalar to_end = (1 - tau) * (s_.Lq[0][k] + s_.Lq[1][k]);
            q[k] = s_.at.q[k] + (s_.remainder.q[k] + (-to_end + bend[0] * s_.Lq[0][k]
                + bend[1] * s_.Lq[1][k]));
        }
        return q;
    }

    /// The momentum at tau h within the last step: that at its beginning and the integral of -dH/dq
    /// at the nodes, put together in the functions that the velocity of the curve is made of. From
    /// the exact solution it is O(h^3) away, as the position is; there is one where there is a
    /// position.
    [[nodiscard]] Vector momentum(Scalar tau) const {
        if (!s_.has_ended()) { return hvi::detail::nowhere(Vector(system_.size())); }
        const auto bend = hvi::detail::departures(curve_p, tau);
        Vector p = s_.at.p;
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            const Scalar to_end = (1 - tau) * (s_.Lp[0][k] + s_.Lp[1][k]);
            p[k] = s_.at.p[k] + (-to_end + bend[0] * s_.Lp[0][k] + bend[1] * s_.Lp[1][k]);
        }
        return p;
    }

    /// H_d^+(q_0, p_1), (4.19) of the paper, of the last step, from (q_0, p_0) to (q_1, p_1): the
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

    static constexpr Scalar c[2] = {
        // c_1 = 1/2-sqrt(3)/6
        rounded(0.21132487f, 0.2113248654051871, 0x1.97p-57, 0x1.96f383f0da826p-57, 0x1.a8p-110),
        // c_2 = 1/2+sqrt(3)/6
        rounded(0.7886751f, 0.7886751345948129, 0x1.35p-56, 0x1.34863e0792becp-56, 0x1.3p-109),
    };

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
    // As much of p, times Lp_i.
    static constexpr Scalar curve_p[2][1] = {
        {
            // curve_p_1,1 = -sqrt(3)/3
            rounded(-0.57735026f, -0.5773502691896257, -0x1.348p-55, -0x1.34863e0792becp-55,
                -0x1.28p-108),
        },
        {
            // curve_p_2,1 = sqrt(3)/3
            rounded(0.57735026f, 0.5773502691896257, 0x1.348p-55, 0x1.34863e0792becp-55,
                0x1.28p-108),
        },
    };

    /// Starting values: the polynomial through the slopes of the last two steps, else slopes as at
    /// the start of this one.
    void predict() {
        if (s_.goes_on && has_slopes_before_) {
            for (Index k = 0; k < s_.at.q.size(); ++k) {
                const Scalar Lq_1 = s_.Lq[0][k];
                const Scalar Lq_2 = s_.Lq[1][k];
                const Scalar Lq_before_1 = Lq_before_[0][k];
                const Scalar Lq_before_2 = Lq_before_[1][k];
                Lq_before_[0][k] = Lq_1;
                Lq_before_[1][k] = Lq_2;
                const Scalar Lp_1 = s_.Lp[0][k];
                const Scalar Lp_2 = s_.Lp[1][k];
                const Scalar Lp_before_1 = Lp_before_[0][k];
                const Scalar Lp_before_2 = Lp_before_[1][k];
                Lp_before_[0][k] = Lp_1;
                Lp_before_[1][k] = Lp_2;
                s_.Lq[0][k] = N[0][0] * Lq_1 + N[0][1] * Lq_2 + N_before[0][0] * Lq_before_1
                    + N_before[0][1] * Lq_before_2;
                s_.Lq[1][k] = N[1][0] * Lq_1 + N[1][1] * Lq_2 + N_before[1][0] * Lq_before_1
                    + N_before[1][1] * Lq_before_2;
                s_.Lp[0][k] = N[0][0] * Lp_1 + N[0][1] * Lp_2 + N_before[0][0] * Lp_before_1
                    + N_before[0][1] * Lp_before_2;
                s_.Lp[1][k] = N[1][0] * Lp_1 + N[1][1] * Lp_2 + N_before[1][0] * Lp_before_1
                    + N_before[1][1] * Lp_before_2;
            }
            return;
        }
        has_slopes_before_ = s_.goes_on;
        Lq_before_ = s_.Lq;
        Lp_before_ = s_.Lp;
        auto&& slope = hvi::detail::scratch(s_.slope);
        system_.dHdp(s_.at.q, s_.at.p, clock_.start, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lq[0][k] = s_.h * b[0] * slope[k];
            s_.Lq[1][k] = s_.h * b[1] * slope[k];
        }
        system_.dHdq(s_.at.q, s_.at.p, clock_.start, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.h * b[0] * slope[k];
            s_.Lp[1][k] = -s_.h * b[1] * slope[k];
        }
    }

    /// The stage equations of Q_1, Q_2, P_1, P_2, which are solved at once.
    struct Coupled {
        const System& system;
        const hvi::detail::Clock<Scalar, 2>& clock;
        hvi::detail::Stages<Vector, 2, 2>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 2> unknown_q{0, 1};
        static constexpr std::array<std::size_t, 2> unknown_p{0, 1};
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
                    + m[0][1] * s.Lp[1][k]));
                const Scalar P_2 = hvi::detail::moved(p, e_p + (m[1][0] * s.Lp[0][k]
                    + m[1][1] * s.Lp[1][k]));
                s.change.p[k] = hvi::detail::abs(P_1 - s.P[0][k]) + hvi::detail::abs(P_2
                    - s.P[1][k]);
                s.P[0][k] = P_1;
                s.P[1][k] = P_2;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_1 = hvi::detail::moved(q, e_q + (m[0][0] * s.Lq[0][k]
                    + m[0][1] * s.Lq[1][k]));
                const Scalar Q_2 = hvi::detail::moved(q, e_q + (m[1][0] * s.Lq[0][k]
                    + m[1][1] * s.Lq[1][k]));
                s.change.q[k] = hvi::detail::abs(Q_1 - s.Q[0][k]) + hvi::detail::abs(Q_2
                    - s.Q[1][k]);
                s.Q[0][k] = Q_1;
                s.Q[1][k] = Q_2;
            }
        }

        /// Lq_j = h b_j dH/dp.
        void velocities() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdp(s.Q[0], s.P[0], clock.t[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[0][k] = s.h * b[0] * slope[k];
            }
            system.dHdp(s.Q[1], s.P[1], clock.t[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[1][k] = s.h * b[1] * slope[k];
            }
        }

        /// Lp_i = -h b_i dH/dq.
        void forces() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.Q[0], s.P[0], clock.t[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[0][k] = -s.h * b[0] * slope[k];
            }
            system.dHdq(s.Q[1], s.P[1], clock.t[1], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[1][k] = -s.h * b[1] * slope[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[0][k])
                + hvi::detail::abs(s.Q[1][k]) + hvi::detail::abs(s.Lq[0][k])
                + hvi::detail::abs(s.Lq[1][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.P[1][k]) + hvi::detail::abs(s.Lp[0][k])
                + hvi::detail::abs(s.Lp[1][k]);
        }
    };

    /// The sum over stages of h b_i (P_i . dH/dp(Q_i, P_i) - H(Q_i, P_i)): see (4.19). The step
    /// from x has been taken, and x not moved.
    [[nodiscard]] Scalar integral_over_step([[maybe_unused]] const State& x) const {
        Scalar sum = 0;
        sum += hvi::detail::dot(s_.P[0], s_.Lq[0]);
        sum += hvi::detail::dot(s_.P[1], s_.Lq[1]);
        sum += -s_.h * b[0] * system_.energy(s_.Q[0], s_.P[0], clock_.t[0]);
        sum += -s_.h * b[1] * system_.energy(s_.Q[1], s_.P[1], clock_.t[1]);
        return sum;
    }

    System system_;
    hvi::detail::Clock<Scalar, 2> clock_;
    hvi::detail::Stages<Vector, 2, 2> s_;
    typename Solver::template Iteration<Vector> solver_;
    decltype(s_.Lq) Lq_before_{};  // of the step before the last
    decltype(s_.Lp) Lp_before_{};  // of the step before the last
    bool has_slopes_before_ = false;  // the last step went on from it
    hvi::detail::ActionSum<State> action_;
};

using InTime = BasicInTime<double>;

}  // namespace hvi::generated
