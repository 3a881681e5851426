// Fixed-point iteration for coupled stages: no derivatives, no linear algebra; for h that is small
// against the fastest period.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/arithmetic.hpp>
#include <hvi/round_off.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// Solver policy of generated steppers, the default.
struct FixedPoint {
    static constexpr int most_iterations = 200;
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    class Iteration {
    public:
        /// Partitioned sweeps, each new value used at once: P from Lp, Lq from dHdp, Q from Lq, Lp
        /// from dHdq. For separable H one of them contracts as much as two sweeps of Jacobi's.
        /// Precondition: Lq and Lp hold starting values; for separable H Lp does. Gives up after
        /// `most` iterations.
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled, int most = most_iterations) {
            if constexpr (!Coupled::separable) { coupled.positions(); }
            round_off_.begin(coupled.s.n);
            sweep(coupled);  // what it changes is measured against values of no meaning
            for (int iteration = 2; iteration <= most; ++iteration) {
                coupled.forces();
                sweep(coupled);
                switch (judge(coupled)) {
                case detail::Verdict::go_on: break;
                case detail::Verdict::unchanged: return Status(Status::Code::ok, iteration);
                case detail::Verdict::at_noise:
                    coupled.forces();
                    return Status(Status::Code::ok, iteration);
                case detail::Verdict::not_finite:
                    // NOTE: later than in the first sweeps it is the iteration that diverges.
                    return Status(iteration == 2 ? Status::Code::not_finite
                                                 : Status::Code::not_converged,
                                  iteration);
                }
            }
            return Status(Status::Code::not_converged, most);
        }

    private:
        template <class Coupled>
        static void sweep(Coupled& coupled) {
            coupled.momenta();
            coupled.velocities();
            coupled.positions();
        }

        /// For separable H a sweep is a map of the positions alone: when they stay, all stays.
        template <class Coupled>
        [[nodiscard]] detail::Verdict judge(const Coupled& coupled) {
            constexpr bool by_p = Coupled::has_p && !(Coupled::separable && Coupled::has_q);
            return round_off_.template judge<Coupled::has_q, by_p>(coupled.s.change, coupled);
        }

        detail::RoundOff<Vector> round_off_{8 * detail::epsilon<detail::ScalarOf<Vector>>};
    };
};

}  // namespace hvi
