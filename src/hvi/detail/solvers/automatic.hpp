// Fixed points while they contract, else Newton's method.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/solvers/pause.hpp>
#include <hvi/fixed_point.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// Solver policy of generated steppers: FixedPoint, and `Newton` for the steps on which FixedPoint
/// is slow or fails. While it stays slow, Newton's method also takes the next 1, 2, 4, ... steps.
/// Both solve the equations to round-off, so that a change between them does not show in the
/// energy.
template <class Newton>
struct Automatic {
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    class Iteration {
    public:
        /// Preconditions: those of FixedPoint.
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled) {
            if (!coupled.s.goes_on) { pause_.forget(); }
            pause_.pass();
            if (!pause_.is_over()) { return solve_stiff(coupled); }
            const Status status = fixed_point_.solve(coupled, most_iterations);
            if (status.ok() && status.iterations <= slow) {
                pause_.forget();
                return status;
            }
            pause_.begin();
            return status.ok() ? status : solve_stiff(coupled);
        }

    private:
        // NOTE: measured on six scenes of 1 to 18 degrees of freedom, with 2 to 8 stages: a step of
        // Newton's method takes as long as 60 to 400 sweeps one by one, and as 90 to 800 in lanes
        // (40 for cheap steps of two stages).
        static constexpr int slow = 100;
        static constexpr int most_iterations = 2 * slow;

        /// Solves by Newton's method. NOTE: a function of its own, so that compilers keep all
        /// registers for the fixed point.
        template <class Coupled>
        [[nodiscard, gnu::noinline, gnu::cold]] Status solve_stiff(Coupled coupled) {
            return newton_.solve(coupled);
        }

        FixedPoint::template Iteration<Vector> fixed_point_;
        typename Newton::template Iteration<Vector> newton_;
        detail::Pause<1> pause_;  ///< steps until fixed points are tried again
    };
};

}  // namespace hvi
