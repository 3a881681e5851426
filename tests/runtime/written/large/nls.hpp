// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method midpoint discrete_nls.toml --solver newton --unroll no --name Nls
// SPDX-License-Identifier: MIT
//
// midpoint: symplectic, 1 stage, for general Hamiltonians.
// Basis functions of tau: 1.
// A == A~: a Runge-Kutta method, which conserves all quadratic invariants.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 1/2
//     b_1 = 1
//     a_1,1 = 1/2
//     a~_i,j = a_i,j
//
// Choices:
//
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

#include <cstddef>
#include <utility>

#include <hvi/detail/solvers/newton_pair_products.hpp>
#include <hvi/detail/stages/stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene discrete-nls of any size with midpoint, computed in Number: float, double or long
/// double. States hold std::vector.
template <class Number>
class BasicNls {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;

    /// As the scene has them.
    struct Parameters {
        Place N = 10;
        Scalar k = Scalar(8.0);  // k = 8
    };

    /// H = sum(i=1..N,(q[i]^2+p[i]^2)^2/4)-k*sum(i=1..N-1,q[i]*q[i+1]+p[i]*p[i+1])
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
            c1_ = parameters.k;
        }

        /// Degrees of freedom.
        [[nodiscard]] std::size_t size() const { return size_; }

        /// Whether vectors have the size of the system, and all that sums look at is there: lists
        /// may be too short.
        [[nodiscard]] bool fits(const Vector& q, const Vector& p) const {
            return fits_ && q.size() == size_ && p.size() == size_;
        }

        void add_by_q_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                hvi::detail::add(out + q_at_ + (i), V(a1 * (a1 * a1 + a2 * a2)));
            });
        }

        void add_by_q_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(q + q_at_ + (i + 1));
                hvi::detail::subtract(out + q_at_ + (i), V(c1_ * a2));
                hvi::detail::subtract(out + q_at_ + (i + 1), V(c1_ * a1));
            });
        }

        void dHdq([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p, Vector& out)
            const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_q_1(q.data(), p.data(), out.data(), 1, N_ + 1);
            add_by_q_2(q.data(), p.data(), out.data(), 1, N_);
        }

        void add_by_p_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                hvi::detail::add(out + p_at_ + (i), V(a2 * (a1 * a1 + a2 * a2)));
            });
        }

        void add_by_p_3([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p, Scalar*
            out, Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(p + p_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i + 1));
                hvi::detail::subtract(out + p_at_ + (i), V(c1_ * a2));
                hvi::detail::subtract(out + p_at_ + (i + 1), V(c1_ * a1));
            });
        }

        void dHdp([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p, Vector& out)
            const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_p_1(q.data(), p.data(), out.data(), 1, N_ + 1);
            add_by_p_3(q.data(), p.data(), out.data(), 1, N_);
        }

        void add_product_by_q_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p, Scalar* out,
            Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                const V a3 = stretch.load(way + q_at_ + (i));
                const V a4 = stretch.load(way_p + p_at_ + (i));
                const V t1 = a1 * a1;
                hvi::detail::add(out + q_at_ + (i), V((t1 + a2 * a2) * a3
                    + Scalar(2.0) * (a1 * a2 * a4 + t1 * a3)));
            });
        }

        void add_product_by_q_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p, Scalar* out,
            Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(way + q_at_ + (i));
                const V a2 = stretch.load(way + q_at_ + (i + 1));
                hvi::detail::subtract(out + q_at_ + (i), V(c1_ * a2));
                hvi::detail::subtract(out + q_at_ + (i + 1), V(c1_ * a1));
            });
        }

        /// Rows by q of d2H times a vector: way of positions, way_p of momenta.
        void d2Hdq([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] const Vector& way, [[maybe_unused]] const Vector& way_p, Vector& out)
            const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_product_by_q_1(q.data(), p.data(), way.data(), way_p.data(), out.data(), 1, N_ + 1);
            add_product_by_q_2(q.data(), p.data(), way.data(), way_p.data(), out.data(), 1, N_);
        }

        void add_product_by_p_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p, Scalar* out,
            Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(q + q_at_ + (i));
                const V a2 = stretch.load(p + p_at_ + (i));
                const V a3 = stretch.load(way + q_at_ + (i));
                const V a4 = stretch.load(way_p + p_at_ + (i));
                const V t1 = Scalar(2.0) * (a1 * a2 * a3) + a4 * (a1 * a1
                    + Scalar(3.0) * (a2 * a2));
                hvi::detail::add(out + p_at_ + (i), V(t1));
            });
        }

        void add_product_by_p_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] const Scalar* way, [[maybe_unused]] const Scalar* way_p, Scalar* out,
            Place from, Place to) const {
            hvi::detail::along<Scalar, 8>(from, to, [&](auto stretch, [[maybe_unused]] Place i)
                HVI_INLINED {
                using V = hvi::detail::ValueOf<decltype(stretch)>;
                const V a1 = stretch.load(way_p + p_at_ + (i));
                const V a2 = stretch.load(way_p + p_at_ + (i + 1));
                hvi::detail::subtract(out + p_at_ + (i), V(c1_ * a2));
                hvi::detail::subtract(out + p_at_ + (i + 1), V(c1_ * a1));
            });
        }

        /// Rows by p of d2H times a vector: way of positions, way_p of momenta.
        void d2Hdp([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] const Vector& way, [[maybe_unused]] const Vector& way_p, Vector& out)
            const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_product_by_p_1(q.data(), p.data(), way.data(), way_p.data(), out.data(), 1, N_ + 1);
            add_product_by_p_2(q.data(), p.data(), way.data(), way_p.data(), out.data(), 1, N_);
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
                    const V a1 = stretch.load(q + q_at_ + (i));
                    const V a2 = stretch.load(p + p_at_ + (i));
                    const V t1 = a1 * a1 + a2 * a2;
                    inner.add(V(Scalar(0.25) * (t1 * t1)));
                });
                total.add(inner.sum());
            }
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_, [&](auto stretch, [[maybe_unused]] Place i)
                    HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(q + q_at_ + (i));
                    const V a2 = stretch.load(q + q_at_ + (i + 1));
                    inner.add(V(-a1 * a2 * c1_));
                });
                total.add(inner.sum());
            }
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_, [&](auto stretch, [[maybe_unused]] Place i)
                    HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(p + p_at_ + (i));
                    const V a2 = stretch.load(p + p_at_ + (i + 1));
                    inner.add(V(-a1 * a2 * c1_));
                });
                total.add(inner.sum());
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
                q[q_at_ + i] = hvi::math::cos(Scalar(3.0) * static_cast<Scalar>(i));
            }
            for (Place i = 1; i <= N_; ++i) {
                p[p_at_ + i] = hvi::math::sin(Scalar(5.0) * static_cast<Scalar>(i));
            }
        }

        Scalar c1_ = 0;
        Place N_;
        Place q_at_ = 0;
        Place p_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
    };

    using Solver = hvi::NewtonOfPairProducts;

    using State = hvi::State<Vector>;

    BasicNls() : BasicNls(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicNls(const Parameters& parameters, unsigned threads = 1) : system_(parameters,
        threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H = sum(i=1..N,(q[i]^2+p[i]^2)^2/4)-k*sum(i=1..N-1,q[i]*q[i+1]+p[i]*p[i+1]); not a number
    /// where x does not have the system's size
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p);
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
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, s_});
        if (!status.ok()) { return status; }

        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.add(s_.at.q[k], s_.remainder.q[k], s_.Lq[0][k]);
            s_.add(s_.at.p[k], s_.remainder.p[k], s_.Lp[0][k]);
        }
        return s_.end(x, status.iterations);
    }

    /// Forgets what the last step left: remainders of the sums, slopes, factors of Newton's method.
    void reset() { s_.forget(); }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    static constexpr Scalar b[1] = {
        Scalar(1.0),  // b_1 = 1
    };

    // m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij.
    static constexpr Scalar m[1][1] = {
        {
            Scalar(0.5),  // m_1,1 = 1/2
        },
    };
    static_assert(hvi::detail::complementary(m, m), "the method is symplectic");

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[1][1] = {
        {
            Scalar(1.0),
        },
    };

    /// Starting values: the polynomial through the slopes of the last step, else slopes as at the
    /// start of this one.
    void predict() {
        if (s_.goes_on) {
            for (Index k = 0; k < s_.at.q.size(); ++k) {
                const Scalar Lq_1 = s_.Lq[0][k];
                const Scalar Lp_1 = s_.Lp[0][k];
                s_.Lq[0][k] = N[0][0] * Lq_1;
                s_.Lp[0][k] = N[0][0] * Lp_1;
            }
            return;
        }
        auto&& slope = hvi::detail::scratch(s_.slope);
        system_.dHdp(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lq[0][k] = s_.h * slope[k];
        }
        system_.dHdq(s_.at.q, s_.at.p, slope);
        for (Index k = 0; k < s_.at.q.size(); ++k) {
            s_.Lp[0][k] = -s_.h * slope[k];
        }
    }

    /// The stage equations of Q_1, P_1, which are solved at once.
    struct Coupled {
        const System& system;
        hvi::detail::Stages<Vector, 1, 1>& s;

        static constexpr bool separable = false;
        static constexpr bool has_q = true;
        static constexpr bool has_p = true;
        static constexpr std::array<std::size_t, 1> unknown_q{0};
        static constexpr std::array<std::size_t, 1> unknown_p{0};
        static constexpr Scalar coefficient_q(std::size_t i, std::size_t j) { return m[i][j]; }
        static constexpr Scalar coefficient_p(std::size_t j, std::size_t i) { return m[j][i]; }
        static constexpr Scalar weight_q(std::size_t j) { return b[j]; }
        static constexpr Scalar weight_p(std::size_t i) { return b[i]; }

        /// (4.18d): P_j = p + (e_p + sum_i mt_ji Lp_i).
        void momenta() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar p = s.at.p[k];
                const Scalar e_p = s.remainder.p[k];
                const Scalar P_1 = hvi::detail::moved(p, e_p + (m[0][0] * s.Lp[0][k]));
                s.change.p[k] = hvi::detail::abs(P_1 - s.P[0][k]);
                s.P[0][k] = P_1;
            }
        }

        /// (4.18c): Q_i = q + (e_q + sum_j m_ij Lq_j).
        void positions() {
            for (Index k = 0; k < s.at.q.size(); ++k) {
                const Scalar q = s.at.q[k];
                const Scalar e_q = s.remainder.q[k];
                const Scalar Q_1 = hvi::detail::moved(q, e_q + (m[0][0] * s.Lq[0][k]));
                s.change.q[k] = hvi::detail::abs(Q_1 - s.Q[0][k]);
                s.Q[0][k] = Q_1;
            }
        }

        /// Lq_j = h b_j dH/dp.
        void velocities() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdp(s.Q[0], s.P[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lq[0][k] = s.h * slope[k];
            }
        }

        /// Lp_i = -h b_i dH/dq.
        void forces() {
            auto&& slope = hvi::detail::scratch(s.slope);
            system.dHdq(s.Q[0], s.P[0], slope);
            for (Index k = 0; k < s.at.q.size(); ++k) {
                s.Lp[0][k] = -s.h * slope[k];
            }
        }

        void nudge(Scalar factor) { s.nudge(unknown_q, unknown_p, factor); }

        /// Size that the rounding of component k of Q is compared with.
        [[nodiscard]] Scalar size_q([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.Q[0][k])
                + hvi::detail::abs(s.Lq[0][k]);
        }

        /// Size that the rounding of component k of P is compared with.
        [[nodiscard]] Scalar size_p([[maybe_unused]] Index k) const {
            return hvi::detail::abs(s.at.p[k]) + hvi::detail::abs(s.P[0][k])
                + hvi::detail::abs(s.Lp[0][k]);
        }
    };

    System system_;
    hvi::detail::Stages<Vector, 1, 1> s_;
    typename Solver::template Iteration<Vector> solver_;
};

using Nls = BasicNls<double>;

}  // namespace hvi::generated
