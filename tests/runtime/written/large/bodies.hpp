// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:3 bodies.toml --unroll no --dense --name Bodies
// SPDX-License-Identifier: MIT
//
// gauss:3: symplectic, 3 stages, for Hamiltonians of rotating bodies.
// Basis functions of tau: 1, tau, tau^2.
// In natural charts, which conserves momentum maps of rotations of space.
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
//     rotations move in a chart at the start of the step, in which they are curves of the method's
//         functions: interpolation in natural charts commutes with rotations of space: momentum
//         maps are kept (Lemmas 5.4 and 5.5)
//     the momentum of a chart at the start is solved for as well: the chart moves with the state;
//         to begin with the momentum of the body makes no symplectic step
//     the state has a time: H depends on it
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

#include <hvi/detail/groups/body_space.hpp>
#include <hvi/detail/groups/coupled_charts.hpp>
#include <hvi/detail/stages/clock.hpp>
#include <hvi/detail/stages/curve.hpp>
#include <hvi/detail/stepper.hpp>
#include <hvi/fixed_point.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene bodies of any size with gauss:3, computed in Number: float, double or long double.
/// States hold std::vector.
/// Bodies with axes that pull at each other, each on a spring
template <class Number>
class BasicBodies {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;
    using Space = hvi::detail::BodySpace<Number>;

    /// As the scene has them.
    struct Parameters {
        Place N = 4;
        Scalar w = hvi::detail::rounded<Scalar>(0.33333334f, 0.3333333333333333, 0x1.558p-56,
            0x1.5555555555555p-56, 0x1.5p-110);  // w = 1/3
        std::vector<Scalar> inertia = hvi::detail::listed<Scalar>({
            Scalar(1.0),
            Scalar(2.0),
            Scalar(2.5),
        });
    };

    /// H =
    /// sum(k=1..N,sum(i=1..3,p[k,i]^2/2+x[k,i]^2/2+L[k,i]^2/(2*inertia[i])))+sum(k=1..N-1,sum(l=k
    /// +1..N,d[k,l]*(R[k,1,3]*R[l,1,3]+R[k,2,3]*R[l,2,3]+R[k,3,3]*R[l,3,3])))+w*cos(t)
    /// *sum(k=1..N,R[k,3,1])
    struct System {
        using Scalar = Number;
        using Vector = std::vector<Number>;

        explicit System(const Parameters& parameters, unsigned threads = 1)
            : N_(parameters.N), inertia_values_(parameters.inertia), team_(threads) {
            Place in_q = 0, in_p = 0;
            x_step_1_ = hvi::detail::count_of(1, 3);
            x_at_ = in_q - (1) - (1) * x_step_1_;
            in_q += hvi::detail::count_of(1, N_) * x_step_1_;
            R_step_2_ = hvi::detail::count_of(1, 3);
            R_step_1_ = hvi::detail::count_of(1, 3) * R_step_2_;
            R_at_ = in_q - (1) - (1) * R_step_2_ - (1) * R_step_1_;
            in_q += hvi::detail::count_of(1, N_) * R_step_1_;
            p_step_1_ = hvi::detail::count_of(1, 3);
            p_at_ = in_p - (1) - (1) * p_step_1_;
            in_p += hvi::detail::count_of(1, N_) * p_step_1_;
            L_step_1_ = hvi::detail::count_of(1, 3);
            L_at_ = in_p - (1) - (1) * L_step_1_;
            in_p += hvi::detail::count_of(1, N_) * L_step_1_;
            inertia_at_ = 0 - (1);
            size_ = static_cast<std::size_t>(in_q);
            degrees_ = static_cast<std::size_t>(in_p);
            fits_ = fits_ && 1 <= static_cast<Place>(inertia_values_.size());
            fits_ = fits_ && 2 <= static_cast<Place>(inertia_values_.size());
            fits_ = fits_ && 3 <= static_cast<Place>(inertia_values_.size());
            c1_ = parameters.w;
        }

        /// Degrees of freedom.
        [[nodiscard]] std::size_t size() const { return degrees_; }

        /// Whether vectors have the size of the system, and all that sums look at is there: lists
        /// may be too short.
        [[nodiscard]] bool fits(const Vector& q, const Vector& p) const {
            return fits_ && q.size() == size_ && p.size() == degrees_;
        }

        void add_by_q_2([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            for (Place index_k = from; index_k < to; ++index_k) {
                const Scalar a1 = q[x_at_ + (index_k) * x_step_1_ + (1)];
                const Scalar a2 = q[x_at_ + (index_k) * x_step_1_ + (2)];
                const Scalar a3 = q[x_at_ + (index_k) * x_step_1_ + (3)];
                out[x_at_ + (index_k) * x_step_1_ + (1)] += a1;
                out[x_at_ + (index_k) * x_step_1_ + (2)] += a2;
                out[x_at_ + (index_k) * x_step_1_ + (3)] += a3;
                out[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_
                    + (1)] += c1_ * hvi::math::cos(t);
            }
        }

        void add_by_q_3([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to, Place stride) const {
            for (Place index_k = from; index_k < to; index_k += stride) {
                for (Place l = index_k + 1; l <= N_; ++l) {
                    const Scalar a1 = q[x_at_ + (index_k) * x_step_1_ + (1)];
                    const Scalar a2 = q[x_at_ + (index_k) * x_step_1_ + (2)];
                    const Scalar a3 = q[x_at_ + (index_k) * x_step_1_ + (3)];
                    const Scalar a4 = q[x_at_ + (l) * x_step_1_ + (1)];
                    const Scalar a5 = q[x_at_ + (l) * x_step_1_ + (2)];
                    const Scalar a6 = q[x_at_ + (l) * x_step_1_ + (3)];
                    const Scalar a7 = q[R_at_ + (index_k) * R_step_1_ + (1) * R_step_2_ + (3)];
                    const Scalar a8 = q[R_at_ + (l) * R_step_1_ + (1) * R_step_2_ + (3)];
                    const Scalar a9 = q[R_at_ + (index_k) * R_step_1_ + (2) * R_step_2_ + (3)];
                    const Scalar a10 = q[R_at_ + (l) * R_step_1_ + (2) * R_step_2_ + (3)];
                    const Scalar a11 = q[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_ + (3)];
                    const Scalar a12 = q[R_at_ + (l) * R_step_1_ + (3) * R_step_2_ + (3)];
                    const Scalar t1 = a1 - a4;
                    const Scalar t2 = a2 - a5;
                    const Scalar t3 = a3 - a6;
                    const Scalar t4 = Scalar(1.0) + t1 * t1 + t2 * t2 + t3 * t3;
                    const Scalar t5 = hvi::math::sqrt(t4);
                    const Scalar t6 = Scalar(1.0) / (t4 * t5);
                    const Scalar t7 = t6 * t6 * t5 * (a7 * a8 + a9 * a10 + a11 * a12);
                    const Scalar t8 = Scalar(3.0) * t1 * t7;
                    const Scalar t9 = Scalar(3.0) * t2 * t7;
                    const Scalar t10 = Scalar(3.0) * t3 * t7;
                    out[x_at_ + (index_k) * x_step_1_ + (1)] += -t8;
                    out[x_at_ + (index_k) * x_step_1_ + (2)] += -t9;
                    out[x_at_ + (index_k) * x_step_1_ + (3)] += -t10;
                    out[x_at_ + (l) * x_step_1_ + (1)] += t8;
                    out[x_at_ + (l) * x_step_1_ + (2)] += t9;
                    out[x_at_ + (l) * x_step_1_ + (3)] += t10;
                    out[R_at_ + (index_k) * R_step_1_ + (1) * R_step_2_ + (3)] += a8 * t6;
                    out[R_at_ + (l) * R_step_1_ + (1) * R_step_2_ + (3)] += a7 * t6;
                    out[R_at_ + (index_k) * R_step_1_ + (2) * R_step_2_ + (3)] += a10 * t6;
                    out[R_at_ + (l) * R_step_1_ + (2) * R_step_2_ + (3)] += a9 * t6;
                    out[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_ + (3)] += a12 * t6;
                    out[R_at_ + (l) * R_step_1_ + (3) * R_step_2_ + (3)] += a11 * t6;
                }
            }
        }

        void dHdq([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] Scalar t, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_q_2(q.data(), p.data(), t, out.data(), 1, N_ + 1);
            hvi::detail::chunked(team_, 1, N_, out.data(), out.size(), memory_,
                [&](Place from, Place to, Place stride, Scalar* to_out) {
                add_by_q_3(q.data(), p.data(), t, to_out, from, to, stride);
            });
        }

        void add_by_p_1([[maybe_unused]] const Scalar* q, [[maybe_unused]] const Scalar* p,
            [[maybe_unused]] Scalar t, Scalar* out, Place from, Place to) const {
            for (Place index_k = from; index_k < to; ++index_k) {
                const Scalar a1 = p[p_at_ + (index_k) * p_step_1_ + (1)];
                const Scalar a2 = p[L_at_ + (index_k) * L_step_1_ + (1)];
                const Scalar a3 = inertia_values_.data()[inertia_at_ + (1)];
                const Scalar a4 = p[p_at_ + (index_k) * p_step_1_ + (2)];
                const Scalar a5 = p[L_at_ + (index_k) * L_step_1_ + (2)];
                const Scalar a6 = inertia_values_.data()[inertia_at_ + (2)];
                const Scalar a7 = p[p_at_ + (index_k) * p_step_1_ + (3)];
                const Scalar a8 = p[L_at_ + (index_k) * L_step_1_ + (3)];
                const Scalar a9 = inertia_values_.data()[inertia_at_ + (3)];
                out[p_at_ + (index_k) * p_step_1_ + (1)] += a1;
                out[L_at_ + (index_k) * L_step_1_ + (1)] += a2 / a3;
                out[p_at_ + (index_k) * p_step_1_ + (2)] += a4;
                out[L_at_ + (index_k) * L_step_1_ + (2)] += a5 / a6;
                out[p_at_ + (index_k) * p_step_1_ + (3)] += a7;
                out[L_at_ + (index_k) * L_step_1_ + (3)] += a8 / a9;
            }
        }

        void dHdp([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p,
            [[maybe_unused]] Scalar t, Vector& out) const {
            std::fill(out.begin(), out.end(), Scalar(0));
            add_by_p_1(q.data(), p.data(), t, out.data(), 1, N_ + 1);
        }

        void gradient(const Vector& q, const Vector& p, Scalar t, Vector& by_q, Vector& by_p) const
            {
            by_entries_.resize(size_);
            dHdq(q, p, t, by_entries_);
            hvi::detail::by_turns(q, by_entries_, by_q);
            dHdp(q, p, t, by_p);
        }

        [[nodiscard]] Scalar energy([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of, [[maybe_unused]] Scalar t) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            for (Place index_k = 1; index_k <= N_; ++index_k) {
                const Scalar a1 = p[p_at_ + (index_k) * p_step_1_ + (1)];
                const Scalar a2 = p[L_at_ + (index_k) * L_step_1_ + (1)];
                const Scalar a3 = inertia_values_.data()[inertia_at_ + (1)];
                const Scalar a4 = p[p_at_ + (index_k) * p_step_1_ + (2)];
                const Scalar a5 = p[L_at_ + (index_k) * L_step_1_ + (2)];
                const Scalar a6 = inertia_values_.data()[inertia_at_ + (2)];
                const Scalar a7 = p[p_at_ + (index_k) * p_step_1_ + (3)];
                const Scalar a8 = p[L_at_ + (index_k) * L_step_1_ + (3)];
                const Scalar a9 = inertia_values_.data()[inertia_at_ + (3)];
                const Scalar t1 = a1 * a1 + a2 * a2 / a3 + a4 * a4 + a5 * a5 / a6 + a7 * a7
                    + a8 * a8 / a9;
                total.add(Scalar(0.5) * t1);
            }
            for (Place index_k = 1; index_k <= N_; ++index_k) {
                const Scalar a1 = q[x_at_ + (index_k) * x_step_1_ + (1)];
                const Scalar a2 = q[x_at_ + (index_k) * x_step_1_ + (2)];
                const Scalar a3 = q[x_at_ + (index_k) * x_step_1_ + (3)];
                const Scalar a4 = q[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_ + (1)];
                const Scalar t1 = Scalar(0.5) * (a1 * a1) + Scalar(0.5) * (a2 * a2)
                    + Scalar(0.5) * (a3 * a3) + c1_ * a4 * hvi::math::cos(t);
                total.add(t1);
            }
            for (Place index_k = 1; index_k <= N_ - 1; ++index_k) {
                for (Place l = index_k + 1; l <= N_; ++l) {
                    const Scalar a1 = q[x_at_ + (index_k) * x_step_1_ + (1)];
                    const Scalar a2 = q[x_at_ + (index_k) * x_step_1_ + (2)];
                    const Scalar a3 = q[x_at_ + (index_k) * x_step_1_ + (3)];
                    const Scalar a4 = q[x_at_ + (l) * x_step_1_ + (1)];
                    const Scalar a5 = q[x_at_ + (l) * x_step_1_ + (2)];
                    const Scalar a6 = q[x_at_ + (l) * x_step_1_ + (3)];
                    const Scalar a7 = q[R_at_ + (index_k) * R_step_1_ + (1) * R_step_2_ + (3)];
                    const Scalar a8 = q[R_at_ + (l) * R_step_1_ + (1) * R_step_2_ + (3)];
                    const Scalar a9 = q[R_at_ + (index_k) * R_step_1_ + (2) * R_step_2_ + (3)];
                    const Scalar a10 = q[R_at_ + (l) * R_step_1_ + (2) * R_step_2_ + (3)];
                    const Scalar a11 = q[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_ + (3)];
                    const Scalar a12 = q[R_at_ + (l) * R_step_1_ + (3) * R_step_2_ + (3)];
                    const Scalar t1 = a1 - a4;
                    const Scalar t2 = a2 - a5;
                    const Scalar t3 = a3 - a6;
                    const Scalar t4 = Scalar(1.0) + t1 * t1 + t2 * t2 + t3 * t3;
                    const Scalar t5 = (a7 * a8 + a9 * a10 + a11 * a12) / (t4 * hvi::math::sqrt(t4));
                    total.add(t5);
                }
            }
            return total.sum();
        }

        [[nodiscard]] Scalar spin([[maybe_unused]] const Vector& q_of, [[maybe_unused]] const
            Vector& p_of) const {
            if (!fits(q_of, p_of)) { return std::numeric_limits<Scalar>::quiet_NaN(); }
            [[maybe_unused]] const Scalar* const q = q_of.data();
            [[maybe_unused]] const Scalar* const p = p_of.data();
            hvi::detail::CompensatedTotal<Scalar> total;
            for (Place index_k = 1; index_k <= N_; ++index_k) {
                const Scalar a1 = p[L_at_ + (index_k) * L_step_1_ + (1)];
                const Scalar a2 = p[L_at_ + (index_k) * L_step_1_ + (2)];
                const Scalar a3 = p[L_at_ + (index_k) * L_step_1_ + (3)];
                const Scalar a4 = q[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_ + (3)];
                const Scalar a5 = q[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_ + (1)];
                const Scalar a6 = q[R_at_ + (index_k) * R_step_1_ + (3) * R_step_2_ + (2)];
                total.add(a1 * a5 + a2 * a6 + a3 * a4);
            }
            return total.sum();
        }

        /// Where the scene begins; empty where lists do not fit.
        void begin(Vector& q_of, Vector& p_of) const {
            q_of.clear();
            p_of.clear();
            q_of.assign(size_, Scalar(0));
            [[maybe_unused]] Scalar* const q = q_of.data();
            p_of.assign(degrees_, Scalar(0));
            [[maybe_unused]] Scalar* const p = p_of.data();
            for (Place index_k = 1; index_k <= N_; ++index_k) {
                for (Place i = 1; i <= 3; ++i) {
                    const Scalar t1 = static_cast<Scalar>(index_k)
                        + Scalar(2.0) * static_cast<Scalar>(i);
                    q[x_at_ + index_k * x_step_1_ + i] = hvi::math::sin(t1);
                }
            }
            for (Place index_k = 1; index_k <= N_; ++index_k) {
                const Scalar t1 = hvi::math::sin(Scalar(1) / Scalar(6) *
                    static_cast<Scalar>(index_k));
                const Scalar t2 = t1 * t1;
                const Scalar t3 = static_cast<Scalar>(index_k) * t2;
                const Scalar t4 = Scalar(5.0)
                    + static_cast<Scalar>(index_k) * static_cast<Scalar>(index_k);
                const Scalar t5 = Scalar(1.0) / t4;
                const Scalar t6 = t2 * t5;
                const Scalar t7 = t5 * t3;
                const Scalar t8 = Scalar(1.0) - Scalar(2.0) * t2
                    + Scalar(2.0) * (static_cast<Scalar>(index_k) * t3 * t5);
                const Scalar t9 = Scalar(1.0) / hvi::math::sqrt(t4);
                const Scalar t10 = hvi::math::sin(Scalar(1) / Scalar(3) *
                    static_cast<Scalar>(index_k));
                const Scalar t11 = t10 * t9;
                const Scalar t12 = static_cast<Scalar>(index_k) * t10 * t9;
                const Scalar values[] = {
                    Scalar(1.0) - Scalar(2.0) * t2 + Scalar(2.0) * t6,
                    Scalar(2.0) * (t7 - t11),
                    Scalar(4.0) * t6 + t12,
                    Scalar(2.0) * (t7 + t11),
                    t8,
                    Scalar(4.0) * t7 - t11,
                    Scalar(4.0) * t6 - t12,
                    Scalar(4.0) * t7 + t11,
                    Scalar(1.0) - Scalar(2.0) * t2 + Scalar(8.0) * t6,
                };
                hvi::detail::put(values, q + R_at_ + index_k * R_step_1_ + (1) * R_step_2_ + (1));
            }
            for (Place index_k = 1; index_k <= N_; ++index_k) {
                for (Place i = 1; i <= 3; ++i) {
                    const Scalar t1 = Scalar(3.0) * static_cast<Scalar>(index_k)
                        - static_cast<Scalar>(i);
                    p[p_at_ + index_k * p_step_1_ + i] = Scalar(0.5) * hvi::math::cos(t1);
                }
            }
            for (Place index_k = 1; index_k <= N_; ++index_k) {
                for (Place i = 1; i <= 3; ++i) {
                    const Scalar t1 = Scalar(2.0) * static_cast<Scalar>(index_k)
                        + static_cast<Scalar>(i);
                    p[L_at_ + index_k * L_step_1_ + i] = hvi::math::sin(t1);
                }
            }
        }

        Scalar c1_ = 0;
        Place N_;
        Vector inertia_values_;
        Place x_at_ = 0, x_step_1_ = 0;
        Place R_at_ = 0, R_step_1_ = 0, R_step_2_ = 0;
        Place p_at_ = 0, p_step_1_ = 0;
        Place L_at_ = 0, L_step_1_ = 0;
        Place inertia_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
        std::size_t degrees_ = 0;  // of freedom
        mutable Vector by_entries_{};  // dH/dq, and by the entries of rotations
        mutable hvi::detail::Team team_;
        mutable Vector memory_{};  // of chunks
    };

    using Solver = hvi::FixedPoint;

    using State = hvi::TimedState<Vector>;

    BasicBodies() : BasicBodies(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicBodies(const Parameters& parameters, unsigned threads = 1) : system_(parameters,
        threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H =
    /// sum(k=1..N,sum(i=1..3,p[k,i]^2/2+x[k,i]^2/2+L[k,i]^2/(2*inertia[i])))+sum(k=1..N-1,sum(l=k
    /// +1..N,d[k,l]*(R[k,1,3]*R[l,1,3]+R[k,2,3]*R[l,2,3]+R[k,3,3]*R[l,3,3])))+w*cos(t)
    /// *sum(k=1..N,R[k,3,1]); not a number where x does not have the system's size
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p, x.t);
    }

    /// sum(k=1..N,sum(i=1..3,R[k,3,i]*L[k,i])); not a number where x does not have the system's
    /// size
    [[nodiscard]] Scalar spin(const State& x) const {
        return system_.spin(x.q, x.p);
    }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) {
        if (h == 0) { return {}; }
        if (!clock_.begin(x.t, h, c)) { s_.forget(); }
        if (!clock_.ends()) { return Status(Status::Code::not_finite); }
        if (!system_.fits(x.q, x.p)) {
            return Status(Status::Code::dimension_mismatch);
        }
        Status status = s_.begin(x, h);
        if (!status.ok()) { return status; }
        s_.weigh(b);
        if constexpr (Solver::takes_starting_values) { predict(); }

        status = solver_.solve(Coupled{system_, s_, m, m, clock_});
        const bool is_finite = status.code() != Status::Code::not_finite;
        if (is_finite && !s_.is_in_chart()) {
            return Status(Status::Code::outside_chart, status.iterations);
        }
        if (!status.ok()) { return status; }

        s_.advance();
        status = s_.end(x, status.iterations);
        return clock_.end(x.t, status);
    }

    /// Where the bodies are at tau h within the last step, on the curve of the method (Sections 4.1
    /// and 5.4 of the paper): of a rotation R_0 exp(hat xi(tau)). From the exact solution through
    /// its beginning it is O(h^4) away for all tau in [0, 1]. After a step that failed, after
    /// reset() and before any step there are no numbers.
    [[nodiscard]] Vector position(Scalar tau) const {
        if (!s_.has_ended()) {
            return hvi::detail::nowhere(Vector(system_.size_));
        }
        const auto bend = hvi::detail::departures(curve, tau);
        return s_.position(tau, bend);
    }

    /// Forgets what the last step left: remainders of the sums, slopes, factors of Newton's method.
    void reset() { s_.forget(); }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    // rounded(...) is the number of its comment as float, double, long double or __float128: the
    // one that Scalar is.
    static constexpr auto& rounded = hvi::detail::rounded<Scalar>;

    static constexpr Scalar b[3] = {
        // b_1 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c7p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
        // b_2 = 4/9
        rounded(0.44444445f, 0.4444444444444444, 0x1.c7p-56, 0x1.c71c71c71c71cp-56, 0x1.cp-110),
        // b_3 = 5/18
        rounded(0.2777778f, 0.2777777777777778, -0x1.c7p-57, -0x1.c71c71c71c71cp-57, -0x1.cp-111),
    };

    // m_ij = a_ij/b_j, rounded so that m_ij + m_ji is 1 exactly, as is mt_ij = m_ij.
    static constexpr Scalar m[3][3] = {
        {
            Scalar(0.5),  // m_1,1 = 1/2
            // m_1,2 = 1/2-3*sqrt(15)/20
            rounded(-0.08094752f, -0.08094750193111255, 0x1.78p-56, 0x1.78e53fdbb0d5dp-56,
                0x1p-110),
            // m_1,3 = 1/2-3*sqrt(15)/25
            rounded(0.03524202f, 0.03524199845511, -0x1.03p-55, -0x1.02d7800e8610dp-55,
                -0x1.dp-108),
        },
        {
            // m_2,1 = 1/2+3*sqrt(15)/20
            rounded(1.0809475f, 1.0809475019311126, -0x1.78p-56, -0x1.78e53fdbb0d5dp-56, -0x1p-110),
            Scalar(0.5),  // m_2,2 = 1/2
            // m_2,3 = 1/2-3*sqrt(15)/20
            rounded(-0.08094752f, -0.08094750193111255, 0x1.78p-56, 0x1.78e53fdbb0d5dp-56,
                0x1p-110),
        },
        {
            // m_3,1 = 1/2+3*sqrt(15)/25
            rounded(0.964758f, 0.96475800154489, 0x1.03p-55, 0x1.02d7800e8610dp-55, 0x1.dp-108),
            // m_3,2 = 1/2+3*sqrt(15)/20
            rounded(1.0809475f, 1.0809475019311126, -0x1.78p-56, -0x1.78e53fdbb0d5dp-56, -0x1p-110),
            Scalar(0.5),  // m_3,3 = 1/2
        },
    };
    static_assert(hvi::detail::complementary(m, m), "the method is symplectic");

    static constexpr Scalar c[3] = {
        // c_1 = 1/2-sqrt(15)/10
        rounded(0.11270166f, 0.11270166537925831, -0x1.3p-62, -0x1.2f20060d31b2p-62, -0x1p-115),
        Scalar(0.5),  // c_2 = 1/2
        // c_3 = 1/2+sqrt(15)/10
        rounded(0.88729835f, 0.8872983346207417, -0x1.f6p-57, -0x1.f686ffcf96727p-57, 0.0),
    };

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

    // q_d(tau h) is on the chord but for sum_k curve_ik g_k(tau) times slope i, with g_k(tau) =
    // (P_{k+1}-P_{k-1})(2*tau-1)/2 of Legendre's polynomials P_k.
    static constexpr Scalar curve[3][2] = {
        {
            // curve_1,1 = -sqrt(15)/5
            rounded(-0.7745967f, -0.7745966692414834, 0x1.f7p-56, 0x1.f686ffcf96727p-56, 0.0),
            // curve_1,2 = 2/5
            rounded(0.4f, 0.4, -0x1.998p-56, -0x1.9999999999999p-56, -0x1.3p-109),
        },
        {
            Scalar(0.0),   // curve_2,1 = 0
            Scalar(-0.5),  // curve_2,2 = -1/2
        },
        {
            // curve_3,1 = sqrt(15)/5
            rounded(0.7745967f, 0.7745966692414834, -0x1.f7p-56, -0x1.f686ffcf96727p-56, 0.0),
            // curve_3,2 = 2/5
            rounded(0.4f, 0.4, -0x1.998p-56, -0x1.9999999999999p-56, -0x1.3p-109),
        },
    };

    /// Starting values: the polynomial through the slopes of the last two steps, else slopes as at
    /// the start of this one.
    void predict() {
        if (s_.extrapolate(m, N, N_before)) { return; }
        s_.predict(m, [this](const auto& q, const auto& p, auto& dHdq, auto& dHdp) {
            system_.gradient(q, p, clock_.start, dHdq, dHdp);
        });
    }

    using Stages = hvi::detail::ChartStages<Space, 3>;
    using Coupled = hvi::detail::CoupledCharts<System, Stages, hvi::detail::Clock<Scalar, 3>>;

    System system_;
    hvi::detail::Clock<Scalar, 3> clock_;
    Stages s_;
    typename Solver::template Iteration<Vector> solver_;
};

using Bodies = BasicBodies<double>;

}  // namespace hvi::generated
