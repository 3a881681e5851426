// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method stormer-verlet kepler --lanes gpu --energy --invariants --name VerletKeplerThreads
// SPDX-License-Identifier: MIT
//
// stormer-verlet: symplectic, 2 stages, for separable Hamiltonians.
// Basis functions of tau: 1, cos(pi*tau).
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 0
//     c_2 = 1
//     b_1 = 1/2
//     b_2 = 1/2
//     a_1,1 = 0
//     a_1,2 = 0
//     a_2,1 = 1/2
//     a_2,2 = 1/2
//     a~_1,1 = 1/2
//     a~_1,2 = 0
//     a~_2,1 = 1/2
//     a~_2,2 = 0
//
// Found in H:
//
//     H = T(p) + U(q), and T is quadratic with a constant matrix
//     6 of 16 second derivatives are not zero, 2 constant
//
// Cost:
//
//     no unknowns: nothing is solved for
//     dH/dq once: 1 addition, 5 multiplications, 1 division, 1 square root
//     dH/dp once: nothing to compute
//     evaluations in a step: 1 of dH/dq, 1 of dH/dp
//
// Choices:
//
//     P_1 = P_2 is evaluated once: these stages are equal
//     Q_1 is not solved for: it is q at the start of the step
//     Q_2 takes no sum of its own: it is q at the end of the step
//     no solver: no stage depends on itself: the step is kicks and drifts in turn
//     no compensated summation: the error of the step is far above round-off
//     one force a step is not evaluated: the last one of a step is the first one of the next
//     a trajectory is a thread of a GPU, or a turn of a loop on the host: scalar code without
//         branches fills a GPU by itself
#pragma once

#include <cstddef>
#include <cstdint>

#include <hvi/detail/device/math.hpp>
#include <hvi/detail/device/steps.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene kepler with stormer-verlet, computed in Number: float or double.
/// A planet around a fixed sun, on an ellipse
/// A trajectory is a thread of a GPU, or a turn of a loop on the host, with the same bits: see
/// <hvi/device.hpp>. Each product and each sum is rounded for itself, whatever a compiler is told
/// of contraction; functions are those of hvi.
template <class Number>
class BasicVerletKeplerThreads {
    static_assert(hvi::device::computes_in<Number>,
                  "hvi: a GPU computes in float or double");

public:
    using Scalar = Number;

    /// As the scene has them.
    struct Parameters {
        Scalar mu = Scalar(1.0);  // mu = 1
        Scalar ecc = hvi::detail::rounded<Scalar>(0.6f, 0.6, 0x1.9ap-56, 0x1.9999999999999p-56,
            0x1.3p-109);  // ecc = 3/5
    };

    /// H = (px^2+py^2)/2-mu/sqrt(x^2+y^2), where q is (x, y) and p is (px, py).
    struct System {
        using Scalar = hvi::device::Real<Number>;
        using Vector = hvi::device::Vector<Scalar, 2>;

        HVI_DEVICE explicit System(const Parameters& parameters) {
            c1_ = Scalar(parameters.mu);
        }

        HVI_DEVICE void dHdq(const Vector& q, Vector& out) const {
            const Scalar t1 = q[0] * q[0] + q[1] * q[1];
            const Scalar t2 = c1_ / (t1 * hvi::device::sqrt(t1));
            out[0] = q[0] * t2;
            out[1] = q[1] * t2;
        }

        HVI_DEVICE void dHdp(const Vector& p, Vector& out) const {
            out[0] = p[0];
            out[1] = p[1];
        }

        [[nodiscard]] HVI_DEVICE Scalar energy(const Vector& q, const Vector& p) const {
            const Scalar t1 = Scalar(0.5) * (p[0] * p[0] + p[1] * p[1])
                - c1_ / hvi::device::sqrt(q[0] * q[0] + q[1] * q[1]);
            return t1;
        }

        [[nodiscard]] HVI_DEVICE Scalar angular_momentum(const Vector& q, const Vector& p) const {
            return q[0] * p[1] - q[1] * p[0];
        }

        HVI_DEVICE static void begin(const Parameters& parameters, Vector& q, Vector& p) {
            const Scalar t1 = Scalar(1.0) - Scalar(parameters.ecc);
            const Scalar t2 = Scalar(parameters.mu) * (Scalar(1.0) + Scalar(parameters.ecc));
            q[0] = t1;
            q[1] = Scalar(0.0);
            p[0] = Scalar(0.0);
            p[1] = hvi::device::sqrt(t2 / t1);
        }

        Scalar c1_ = 0;
    };

    /// A trajectory in plain numbers, which may be copied as bytes. To go on from another q, p or
    /// time, take another State: what is below belongs to the step before.
    struct State {
        hvi::device::Vector<Number, 2> q{}, p{};
        hvi::Status::Code status = hvi::Status::Code::ok;  // of the last step
        std::int64_t steps = 0;                            // how many went well

        hvi::device::Vector<Number, 2> slope{};  // the first of the next step
        bool knows_slope = false;
    };

    /// Numbers that all trajectories share: the size of a step, and numbers of the method. They are
    /// made on the host, and kernels take them by value.
    struct Steps {
        explicit Steps(Number size) : h(size) {
            hvi::device::scale(h, b_p, p);
        }

        Number h;
        hvi::device::Vector<Number, 2> p{};
    };

    HVI_DEVICE explicit BasicVerletKeplerThreads(const Parameters& parameters) : system_(parameters)
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

    /// H = (px^2+py^2)/2-mu/sqrt(x^2+y^2)
    [[nodiscard]] HVI_DEVICE Number energy(const State& x) const {
        return system_.energy(hvi::device::load(x.q), hvi::device::load(x.p)).value;
    }

    /// x*py-y*px
    [[nodiscard]] HVI_DEVICE Number angular_momentum(const State& x) const {
        return system_.angular_momentum(hvi::device::load(x.q), hvi::device::load(x.p)).value;
    }

    /// Advances x by a step: of a negative size back, 0 leaves every bit. Unless the status is ok,
    /// x has kept its numbers, and is not advanced any more.
    HVI_DEVICE void step(State& x, const Steps& by) const {
        if (by.h == 0 || x.status != hvi::Status::Code::ok) { return; }
        Values q = hvi::device::load(x.q);
        Values p = hvi::device::load(x.p);
        Values slope{};
        Values kept = hvi::device::load(x.slope);

        if (!x.knows_slope) { system_.dHdq(q, kept); }
        p[0] = p[0] - by.p[0] * kept[0];
        p[1] = p[1] - by.p[0] * kept[1];
        system_.dHdp(p, slope);
        q[0] = q[0] + by.h * slope[0];
        q[1] = q[1] + by.h * slope[1];
        system_.dHdq(q, kept);
        p[0] = p[0] - by.p[1] * kept[0];
        p[1] = p[1] - by.p[1] * kept[1];

        if (!(hvi::device::are_finite(q, p))) {
            x.status = hvi::Status::Code::not_finite;
            return;
        }
        hvi::device::store(q, x.q);
        hvi::device::store(p, x.p);
        ++x.steps;
        hvi::device::store(kept, x.slope);
        x.knows_slope = true;
    }

private:
    using Values = typename System::Vector;

    static constexpr Scalar b_p[2] = {
        Scalar(0.5),  // b_1 = 1/2
        Scalar(0.5),  // b_2 = 1/2
    };

    System system_;
};

using VerletKeplerThreads = BasicVerletKeplerThreads<double>;

}  // namespace hvi::generated
