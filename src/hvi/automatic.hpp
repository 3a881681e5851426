// Fixed points while they contract, else Newton's method.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/fixed_point.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// Solver policy of generated steppers: FixedPoint, and `Newton` for the steps on which that is
/// slow or fails. Both solve the equations to round-off, so that a change from one to the other
/// does not show in the energy.
template <class Newton>
struct Automatic {
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    class Iteration {
    public:
        /// Preconditions: those of FixedPoint.
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled) {
            const bool goes_on = coupled.s.continues && coupled.s.h == coupled.s.h_before;
            if (stiff_steps_ > 0 && goes_on) { return solve_stiff(coupled); }
            const Status status = fixed_point_.solve(coupled, most_iterations);
            if (status.ok()) {
                stiff_steps_ = status.iterations > slow ? steps_between_trials : 0;
                return status;
            }
            stiff_steps_ = steps_between_trials;
            return solve_stiff(coupled);
        }

    private:
        // NOTE: a step of Newton's method costs as much as some 10 to 20 sweeps.
        static constexpr int slow = 30;
        static constexpr int most_iterations = 2 * slow;
        static constexpr int steps_between_trials = 64;

        /// NOTE: apart, so that compilers keep the fixed point's registers for itself.
        template <class Coupled>
#if defined(__GNUC__)
        [[gnu::noinline, gnu::cold]]
#endif
        [[nodiscard]] Status
        solve_stiff(Coupled coupled) {
            --stiff_steps_;
            return newton_.solve(coupled);
        }

        FixedPoint::template Iteration<Vector> fixed_point_;
        typename Newton::template Iteration<Vector> newton_;
        int stiff_steps_ = 0;  ///< so many more before fixed points are tried again
    };
};

}  // namespace hvi
