// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method gauss:2 driven.toml --lanes gpu --name Gauss2DrivenThreads
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
// Found in H:
//
//     H is not seen to be T(p) + U(q)
//     H depends on the time
//     4 of 4 second derivatives are not zero, 0 constant
//
// Cost:
//
//     4 unknowns are solved for in a step
//     dH/dq and dH/dp once: 3 additions, 8 multiplications
//     evaluations in a step of one iteration: 2 of dH/dq, 2 of dH/dp
//
// Choices:
//
//     the state has a time: H depends on it
//     the stages keep their momenta: on a GPU one form serves any H: positions alone need products
//         of twice the digits
//     dH/dq and dH/dp are evaluated together: what they have in common is computed once, and
//         neither waits for the other, by the count of operations for less than the iterations that
//         this may add
//     a trajectory is a thread of a GPU, or a turn of a loop on the host: scalar code without
//         branches fills a GPU by itself
//     the last step's slopes, extrapolated, are the starting values of the iteration: they are good
//         to the order of the interpolation and cost no evaluation
#pragma once

#include <cstddef>
#include <cstdint>

#include <hvi/detail/device/math.hpp>
#include <hvi/detail/device/stages.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene driven with gauss:2, computed in Number: float or double.
/// A driven motion that is not separable, without functions: t*t is all it has of the time
/// A trajectory is a thread of a GPU, or a turn of a loop on the host, with the same bits: see
/// <hvi/device.hpp>. Each product and each sum is rounded for itself, whatever a compiler is told
/// of contraction; functions are those of hvi.
template <class Number>
class BasicGauss2DrivenThreads {
    static_assert(hvi::device::computes_in<Number>,
                  "hvi: a GPU computes in float or double");

public:
    using Scalar = Number;

    /// As the scene has them.
    struct Parameters {
    };

    /// H = (1+t^2/8)*(q^2+1)*(p^2+1)/2, where q is (q) and p is (p).
    struct System {
        using Scalar = hvi::device::Real<Number>;
        using Vector = hvi::device::Vector<Scalar, 1>;

        HVI_DEVICE explicit System([[maybe_unused]] const Parameters& parameters) {
        }

        HVI_DEVICE void gradient(const Vector& q, const Vector& p, Scalar t, Vector& dHdq, Vector&
            dHdp) const {
            const Scalar t1 = Scalar(1.0) + Scalar(0.125) * (t * t);
            dHdq[0] = t1 * (Scalar(1.0) + p[0] * p[0]) * q[0];
            dHdp[0] = t1 * (Scalar(1.0) + q[0] * q[0]) * p[0];
        }

        HVI_DEVICE static void begin([[maybe_unused]] const Parameters& parameters, Vector& q,
            Vector& p) {
            q[0] = Scalar(0.5);
            p[0] = Scalar(0.25);
        }
    };

    /// A trajectory in plain numbers, which may be copied as bytes. To go on from another q, p or
    /// time, take another State: what is below belongs to the step before.
    struct State {
        hvi::device::Vector<Number, 1> q{}, p{};
        Number t = 0;
        hvi::Status::Code status = hvi::Status::Code::ok;  // of the last step
        std::int64_t steps = 0;                            // how many went well

        int iterations = 0;  // of the last step
        Number remainder_t = 0;
        hvi::device::Vector<Number, 1> remainder_q{}, remainder_p{};
        hvi::device::Vector<Number, 1> slopes_q[2]{};
        hvi::device::Vector<Number, 1> slopes_p[2]{};
        Number size_of_step = 0;  // of these slopes
    };

    /// Numbers that all trajectories share: the size of a step, and numbers of the method. They are
    /// made on the host, and kernels take them by value.
    struct Steps {
        explicit Steps(Number size) : h(size) {
            hvi::device::weigh(h, b, hb);
            hvi::device::scale(h, c, t);
        }

        Number h;
        hvi::device::Vector<Number, 2> hb{};
        hvi::device::Vector<Number, 2> t{};
        hvi::device::Table<Number, 2> m = hvi::device::table_of(BasicGauss2DrivenThreads::m);
        hvi::device::Table<Number, 2> N = hvi::device::table_of(BasicGauss2DrivenThreads::N);
    };

    HVI_DEVICE explicit BasicGauss2DrivenThreads(const Parameters& parameters) : system_(parameters)
        {}

    /// Where the scene begins.
    [[nodiscard]] HVI_DEVICE static State initial(const Parameters& parameters) {
        typename System::Vector q{}, p{};
        System::begin(parameters, q, p);
        State x;
        hvi::device::store(q, x.q);
        hvi::device::store(p, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// Advances x by a step: of a negative size back, 0 leaves every bit. Unless the status is ok,
    /// x has kept its numbers, and is not advanced any more.
    HVI_DEVICE void step(State& x, const Steps& by) const {
        if (by.h == 0 || x.status != hvi::Status::Code::ok) { return; }
        Stages s(x);
        Coupled coupled{system_, by, x, s};
        const bool extrapolates = x.size_of_step == by.h;
        if (!extrapolates) { coupled.begin(); }
        if (extrapolates) {
            s.extrapolate(by.N, x.slopes_q, s.Lq);
            s.extrapolate(by.N, x.slopes_p, s.Lp);
        }

        x.status = hvi::device::solve(coupled, x.iterations);
        if (x.status != hvi::Status::Code::ok) { return; }
        s.advance();
        const hvi::device::Sum<Number> time = hvi::device::time_after(x, by.h);
        if (!(hvi::device::are_finite(s.q, s.p) && hvi::device::is_finite(time.value))) {
            x.status = hvi::Status::Code::not_finite;
            return;
        }
        hvi::device::store(s.q, x.q);
        hvi::device::store(s.p, x.p);
        x.t = time.value.value;
        x.remainder_t = time.remainder.value;
        ++x.steps;
        hvi::device::store(s.remainder_q, x.remainder_q);
        hvi::device::store(s.remainder_p, x.remainder_p);
        for (std::size_t i = 0; i < 2; ++i) {
            hvi::device::store(s.Lq[i], x.slopes_q[i]);
            hvi::device::store(s.Lp[i], x.slopes_p[i]);
        }
        x.size_of_step = by.h;
    }

private:
    using Values = typename System::Vector;

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

    // Slopes of the next step are about N times those of this one.
    static constexpr Scalar N[2][2] = {
        {
            Scalar(-0.7320508075688773), Scalar(1.7320508075688772),
        },
        {
            Scalar(-1.7320508075688772), Scalar(2.732050807568877),
        },
    };

    using Stages = hvi::device::Stages<Number, 1, 2>;

    /// The stage equations of Q_1, Q_2, P_1, P_2, which are solved at once.
    struct Coupled {
        const System& system;
        const Steps& by;
        const State& x;
        Stages& s;

        using Watch = hvi::device::RoundOff<Number, 1>;
        static constexpr bool separable = false, joint = true;

        HVI_DEVICE void positions() { s.positions(by.m); }
        /// Sets starting values: slopes as at the start of the step.
        HVI_DEVICE void begin() {
            Values dHdq, dHdp;
            system.gradient(s.q, s.p, x.t, dHdq, dHdp);
            for (std::size_t i = 0; i < 2; ++i) {
                s.set(s.Lp[i], -by.hb[i], dHdq);
                s.set(s.Lq[i], by.hb[i], dHdp);
            }
        }

        HVI_DEVICE void sweep() {
            s.momenta(by.m);
            positions();
        }

        HVI_DEVICE void evaluate() {
            for (std::size_t i = 0; i < 2; ++i) {
                Values dHdq, dHdp;
                system.gradient(s.Q[i], s.P[i], hvi::device::time_at(x, by.t[i]), dHdq, dHdp);
                s.set(s.Lp[i], -by.hb[i], dHdq);
                s.set(s.Lq[i], by.hb[i], dHdp);
            }
        }
    };

    System system_;
};

using Gauss2DrivenThreads = BasicGauss2DrivenThreads<double>;

}  // namespace hvi::generated
