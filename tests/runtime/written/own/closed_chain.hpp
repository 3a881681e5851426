// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method stormer-verlet closed_chain.toml --unroll no --name ClosedChain
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
// Choices:
//
//     P_1 = P_2 is evaluated once: these stages are equal
//     Q_1 is not solved for: it is q at the start of the step
//     Q_2 takes no sum of its own: it is q at the end of the step
//     no solver: no stage depends on itself: the step is kicks and drifts in turn
//     no compensated summation: the error of the step is far above round-off
//     one force a step is not evaluated: the last one of a step is the first one of the next
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <hvi/detail/coefficients/rounded.hpp>
#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/loops/along.hpp>
#include <hvi/detail/loops/ranges.hpp>
#include <hvi/detail/loops/site_moves.hpp>
#include <hvi/integrate.hpp>
#include <hvi/version.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene closed_chain of any size with stormer-verlet, computed in Number: float, double or
/// long double. States hold std::vector.
template <class Number>
class BasicClosedChain {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");

public:
    using Scalar = Number;
    using Vector = std::vector<Number>;
    using Place = std::ptrdiff_t;

    /// As the scene has them.
    struct Parameters {
        Place N = 90;
    };

    /// H =
    /// sum(i=1..N,p[i]^2/2)+10*(1-exp(-q[1]/2))^2+sum(i=1..N-1,10*(1-exp((q[i]-q[i+1])/2))^2)+10*(1
    /// -exp(q[N]/2))^2
    struct System {
        using Scalar = Number;
        using Vector = std::vector<Number>;
        static constexpr std::size_t dimension = 1;  // indices of a site
        static constexpr std::size_t components = 1;
        using Site = hvi::detail::Site<dimension>;
        static constexpr Site reach = {{1}};

        explicit System(const Parameters& parameters, unsigned /*threads*/ = 1)
            : N_(parameters.N) {
            Place in_q = 0, in_p = 0;
            q_at_ = in_q - (1);
            in_q += hvi::detail::count_of(1, N_);
            p_at_ = in_p - (1);
            in_p += hvi::detail::count_of(1, N_);
            size_ = static_cast<std::size_t>(in_q);
            count_ = in_q / 1;
            fits_ = fits_ && 1 <= N_;
            c1_ = k1 / (Scalar(1.0) + static_cast<Scalar>(parameters.N));
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
                    {{{std::max<Place>({1, 2})}}, {{std::min<Place>({N_ + 1, N_})}}}};
        }

        /// dU/dq of the sites e, e + 1, ... that V stands for, where all their neighbours are; the
        /// first has the indices k.
        template <class V>
        HVI_INLINE_IN_LANES void force([[maybe_unused]] const Scalar* q, [[maybe_unused]] Place e,
            [[maybe_unused]] const Site& k, V (&out)[components]) const {
            const V a1 = hvi::detail::Stretch<V>::load(q + (e));
            const V a2 = hvi::detail::Stretch<V>::load(q + (e + 1));
            const V a3 = hvi::detail::Stretch<V>::load(q + (e - 1));
            const V t1 = hvi::math::exp(Scalar(0.5) * (a1 - a2));
            const V t2 = hvi::math::exp(-Scalar(0.5) * (a1 - a3));
            out[0] = V(-Scalar(10.0) * ((t1 - t2) * (Scalar(1.0) - (t1 + t2))));
        }

        /// Force on any site.
        void force_at_edge([[maybe_unused]] const Scalar* q, Place, [[maybe_unused]] const Site& k,
            Scalar (&out)[components]) const {
            for (Scalar& each : out) { each = 0; }
            {
                if (k[0] == 1) {
                    const Scalar a1 = q[q_at_ + (1)];
                    const Scalar t1 = hvi::math::exp(-Scalar(0.5) * a1);
                    out[0] += Scalar(10.0) * (t1 * (Scalar(1.0) - t1));
                }
            }
            {
                if (k[0] == N_) {
                    const Scalar a1 = q[q_at_ + (N_)];
                    const Scalar t1 = hvi::math::exp(Scalar(0.5) * a1);
                    out[0] += -Scalar(10.0) * (t1 * (Scalar(1.0) - t1));
                }
            }
            {
                const Place i = k[0] - (0);
                if (1 <= i && i <= N_ - 1) {
                    const Scalar a1 = q[q_at_ + (i)];
                    const Scalar a2 = q[q_at_ + (i + 1)];
                    const Scalar t1 = hvi::math::exp(Scalar(0.5) * (a1 - a2));
                    out[0] += -Scalar(10.0) * t1 * (Scalar(1.0) - t1);
                }
            }
            {
                const Place i = k[0] - (1);
                if (1 <= i && i <= N_ - 1) {
                    const Scalar a1 = q[q_at_ + (i)];
                    const Scalar a2 = q[q_at_ + (i + 1)];
                    const Scalar t1 = hvi::math::exp(Scalar(0.5) * (a1 - a2));
                    out[0] += Scalar(10.0) * t1 * (Scalar(1.0) - t1);
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
                const Scalar a1 = q[q_at_ + (1)];
                const Scalar a2 = q[q_at_ + (N_)];
                const Scalar t1 = Scalar(1.0) - hvi::math::exp(-Scalar(0.5) * a1);
                const Scalar t2 = Scalar(1.0) - hvi::math::exp(Scalar(0.5) * a2);
                total.add(Scalar(10.0) * (t1 * t1 + t2 * t2));
            }
            {
                hvi::detail::Total<Scalar, 8> inner;
                hvi::detail::along<Scalar, 8>(1, N_, [&](auto stretch, [[maybe_unused]] Place i)
                    HVI_INLINED {
                    using V = hvi::detail::ValueOf<decltype(stretch)>;
                    const V a1 = stretch.load(q + q_at_ + (i));
                    const V a2 = stretch.load(q + q_at_ + (i + 1));
                    const V t1 = Scalar(1.0) - hvi::math::exp(Scalar(0.5) * (a1 - a2));
                    inner.add(V(Scalar(10.0) * (t1 * t1)));
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
                q[q_at_
                    + i] = Scalar(1) / Scalar(3) * hvi::math::sin(Scalar(3.0) *
                    (static_cast<Scalar>(i) * c1_));
            }
            for (Place i = 1; i <= N_; ++i) {
                p[p_at_ + i] = Scalar(1) / Scalar(5) * hvi::math::cos(static_cast<Scalar>(i));
            }
        }

        static constexpr Scalar k1 = hvi::detail::rounded<Scalar>(3.1415927f, 3.141592653589793,
            0x1.1a8p-53, 0x1.1a62633145c06p-53, 0x1.cp-106);  // pi
        Scalar c1_ = 0;
        Place N_;
        Place q_at_ = 0;
        Place p_at_ = 0;
        std::size_t size_ = 0;
        bool fits_ = true;
        Place count_ = 0;  // of sites
    };

    using State = hvi::State<Vector>;

    BasicClosedChain() : BasicClosedChain(Parameters{}) {}
    /// `threads`: 0 for as many as there are processors.
    explicit BasicClosedChain(const Parameters& parameters, unsigned threads = 1)
        : system_(parameters), moves_(steps(), threads) {}

    /// Where the scene begins; empty where a list does not fit its sizes.
    [[nodiscard]] static State initial(const Parameters& parameters) {
        State x;
        System(parameters).begin(x.q, x.p);
        return x;
    }
    [[nodiscard]] static State initial() { return initial(Parameters{}); }

    /// H =
    /// sum(i=1..N,p[i]^2/2)+10*(1-exp(-q[1]/2))^2+sum(i=1..N-1,10*(1-exp((q[i]-q[i+1])/2))^2)+10*(1
    /// -exp(q[N]/2))^2; not a number where x does not have the system's size
    [[nodiscard]] Scalar energy(const State& x) const {
        return system_.energy(x.q, x.p);
    }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits.
    [[nodiscard]] Status step(State& x, Scalar h) { return advance(x, h, 1).status; }

    /// Makes many steps of one size, with the bits of single ones, and faster. Where a step fails x is where the last
    /// good one ended.
    [[nodiscard]] hvi::Run advance(State& x, Scalar h, std::int64_t steps) {
        if (!system_.fits(x.q, x.p)) { return {Status(Status::Code::dimension_mismatch)}; }
        const hvi::Run run = moves_.advance(system_, x, h, steps);
        evaluations_ += (run.steps > 0 ? 1 * run.steps + 1 : 0);
        return run;
    }

    /// How often dH/dq was evaluated, for steps that went well.
    [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

    /// Nothing is left from one call to the next.
    void reset() {}

private:
    static constexpr Scalar b_p[2] = {
        Scalar(0.5),  // b_1 = 1/2
        Scalar(0.5),  // b_2 = 1/2
    };

    [[nodiscard]] static std::vector<hvi::detail::Move<Scalar>> steps() {
        using Move = hvi::detail::Move<Scalar>;
        return {
            Move{Move::kick, b_p[0]},
            Move{Move::drift, Scalar(1)},
            Move{Move::kick, b_p[1]},
        };
    }

    System system_;
    hvi::detail::SiteMoves<System, hvi::detail::PlainSums> moves_;
    std::int64_t evaluations_ = 0;
};

using ClosedChain = BasicClosedChain<double>;

}  // namespace hvi::generated
