// Fixed points or Newton's corrections, whichever is cheaper, for stages in lanes.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/solvers/corrected_sweeps.hpp>
#include <hvi/detail/solvers/pause.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/fixed_point.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Costs of the ways to solve the equations of the stages, in one unit; computed when the header is
/// written.
struct SolverCosts {
    int sweep;       ///< of one sweep of fixed points
    int linear;      ///< of one sweep whose linear part is solved exactly; 0: H has none
    int correction;  ///< of a sweep and a correction of its slopes
    int factors;     ///< of factoring the Jacobian with one Hessian
};

}  // namespace detail

/// Solver policy of steppers whose stages are lanes. There are three usual ways: fixed points,
/// fixed points whose linear part is solved exactly, and corrections with one Hessian for all
/// stages. Each step is solved by the way that has cost least on the steps before, and by `Newton`
/// where all three fail. Another way is tried after 8, 16, 32, 64, 64, ... steps, and given up once
/// it costs more. Among steps of several sizes in a row the largest decide. All ways solve the
/// equations to round-off, so that a change between them does not show in the energy.
///
/// Costs are counts of iterations times constants of the header, so that the same steps are solved
/// in the same way on every machine.
template <class Newton>
struct AutomaticOfLanes {
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    class Iteration {
    public:
        /// Preconditions: those of FixedPoint.
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled) {
            constexpr detail::SolverCosts costs = Coupled::costs;
            const bool is_next = coupled.s.goes_on;
            if (!is_next || cheap_ == 0) { return choose(coupled, is_next); }
            // NOTE: most steps of most scenes end here, and nothing is learnt from them.
            other_way_.pass();
            const Attempt sweeps{Way::sweeps, false};
            const Result result = solved(coupled, sweeps, costs);
            if (!result.status.ok() || result.spent > cheap_) {
                return go_on(coupled, sweeps, result);
            }
            cost_ = result.spent;
            return result.status;
        }

    private:
        using Scalar = detail::ScalarOf<Vector>;
        enum class Way { sweeps, linear, corrected, newton };
        /// One attempt to solve a step.
        struct Attempt {
            Way way;
            bool is_from_start;     ///< begins with slopes at the start, not extrapolated ones; see
                                    ///< solved()
            bool is_trial = false;  ///< tries a way that has not been the cheapest
        };
        /// Outcome of an attempt.
        struct Result {
            Status status;
            int spent;  ///< in units of the costs
        };

        /// Solves a step and learns from it. `is_next`: the step goes on from the last one, with
        /// its step size.
        template <class Coupled>
        [[nodiscard, gnu::noinline]] Status choose(Coupled& coupled, bool is_next) {
            constexpr detail::SolverCosts costs = Coupled::costs;
            if (!is_next) { forget(costs); }
            const Scalar size = detail::abs(coupled.s.h);
            decides_ = size >= largest_;
            if (decides_) { largest_ = size; }
            from_start_.pass();
            other_way_.pass();
            others_.pass();
            if (!others_.is_over()) { return solve_stiff(coupled); }
            const Attempt now = first(costs);
            return go_on(coupled, now, solved(coupled, now, costs));
        }

        /// Goes on from an attempt and its outcome until a way has solved the step.
        template <class Coupled>
        [[nodiscard, gnu::noinline]] Status go_on(Coupled& coupled, Attempt now, Result result) {
            constexpr detail::SolverCosts costs = Coupled::costs;
            int iterations = result.status.iterations;
            while (!result.status.ok()) {
                now = after(now, costs);
                if (now.way == Way::newton) {
                    cheap_ = 0;
                    others_.begin();
                    return solve_stiff(coupled);
                }
                result = solved(coupled, now, costs);
                iterations += result.status.iterations;
            }
            learn(now, result.spent, costs);
            cheap_ = now.is_from_start ? 0 : cheap(costs);
            if (cost_ > cheap_) { cheap_ = 0; }
            return Status(Status::Code::ok, iterations);
        }

        /// Returns the cost up to which sweeps are accepted without trying another way; 0: always
        /// compare.
        [[nodiscard]] int cheap(const detail::SolverCosts& costs) const {
            if (usual_ != Way::sweeps) { return 0; }
            int least = least_cost(Way::corrected, costs);
            if (costs.linear > 0) { least = std::min(least, least_cost(Way::linear, costs)); }
            return cost_from_start_ > 0 ? std::min(least, cost_from_start_) : least;
        }

        /// Returns the cost of the fewest iterations that are worth a trial.
        [[nodiscard]] static constexpr int least_cost(Way way, const detail::SolverCosts& costs) {
            constexpr int iterations = 6;
            switch (way) {
            case Way::sweeps: return iterations * costs.sweep;
            case Way::linear: return iterations * costs.linear;
            case Way::corrected: return costs.factors + iterations * costs.correction;
            case Way::newton: break;
            }
            return 0;
        }

        /// Returns the cost at which an attempt is given up. NOTE: a trial may cost as much as the
        /// usual way. Otherwise the limit includes factors, as from rest the first factors serve
        /// for a correction or two each.
        [[nodiscard]] int most_cost(const Attempt& now, const detail::SolverCosts& costs) const {
            constexpr int corrections = 25;
            return now.is_trial ? cost_ : corrections * costs.correction + 8 * costs.factors;
        }

        /// Makes an attempt. NOTE: long steps of stiff systems that begin with the slopes at the
        /// start lead far away, where second derivatives have no meaning. Without any slopes the
        /// stages are near a point where H is defined.
        template <class Coupled>
        [[nodiscard]] Result solved(Coupled& coupled, const Attempt& now,
                                    const detail::SolverCosts& costs) {
            const int most = most_cost(now, costs);
            if (now.way != Way::sweeps) {
                if (now.is_from_start) { coupled.s.rest(); }
                const Status status = solve_corrected(coupled, now.way, most);
                return {status, corrected_.spent()};
            }
            if (now.is_from_start) { coupled.predict(); }
            const Status status = sweeps_.template solve<true>(coupled, most / costs.sweep);
            return {status, status.iterations * costs.sweep};
        }

        /// Chooses the first attempt of a step. NOTE: a way that is not worth a trial does not
        /// block the trial of the next one.
        [[nodiscard]] Attempt first(const detail::SolverCosts& costs) {
            const bool is_from_start = !from_start_.is_over();
            if (!decides_ || !other_way_.is_over()) { return {usual_, is_from_start}; }
            if (cost_ <= least_cost(other_, costs)) { turn(costs); }
            const bool is_trial = cost_ > least_cost(other_, costs);
            return {is_trial ? other_ : usual_, is_from_start, is_trial};
        }

        /// Returns the attempt that follows a failed one.
        [[nodiscard]] Attempt after(const Attempt& failed, const detail::SolverCosts& costs) {
            if (failed.is_trial) { has_tried(costs); }
            if (failed.is_trial || !failed.is_from_start) { return {usual_, true}; }
            constexpr Way in_turn[] = {Way::linear, Way::corrected, Way::sweeps};
            bool is_next = failed.way == usual_;
            for (const Way way : in_turn) {
                const bool is_there = way != Way::linear || costs.linear > 0;
                if (is_next && is_there && way != usual_) { return {way, true}; }
                is_next = is_next || way == failed.way;
            }
            return {Way::newton, true};
        }

        void learn(const Attempt& ended, int cost, const detail::SolverCosts& costs) {
            if (ended.is_trial && cost >= cost_) { return has_tried(costs); }
            const bool is_new = ended.way != usual_;
            others_.forget();
            if (!decides_ && !is_new) { return; }
            usual_ = ended.way;
            cost_ = cost;
            if (is_new) {
                other_way_.forget();
                has_tried(costs);
            }
            learn_start(ended, cost, is_new);
        }

        /// Learns which starting values are better. NOTE: extrapolated slopes may lead to the
        /// solution by a detour.
        void learn_start(const Attempt& ended, int cost, bool is_new) {
            if (is_new) { cost_from_start_ = 0; }
            if (ended.is_from_start) {
                cost_from_start_ = cost;
                if (from_start_.is_over() && !is_new) { from_start_.begin(); }
            } else if (cost_from_start_ > 0 && cost > cost_from_start_) {
                from_start_.begin();
            } else {
                from_start_.forget();
            }
        }

        /// Ends a trial: the next one tries another way.
        void has_tried(const detail::SolverCosts& costs) {
            other_way_.begin();
            turn(costs);
        }

        /// Sets the next way to try.
        void turn(const detail::SolverCosts& costs) {
            do {
                other_ = other_ == Way::sweeps   ? Way::linear
                         : other_ == Way::linear ? Way::corrected
                                                 : Way::sweeps;
            } while (other_ == usual_ || (other_ == Way::linear && costs.linear == 0));
        }

        void forget(const detail::SolverCosts& costs) {
            cheap_ = 0;
            largest_ = 0;
            usual_ = other_ = Way::sweeps;
            cost_ = cost_from_start_ = 0;
            from_start_.forget();
            other_way_.forget();
            others_.forget();
            has_tried(costs);
            corrected_.forget();
        }

        // NOTE: both are functions of their own, so that compilers keep all registers for the
        // sweeps.
        template <class Coupled>
        [[nodiscard, gnu::noinline]] Status solve_corrected(Coupled& coupled,
                                                            [[maybe_unused]] Way way, int most) {
            constexpr detail::SolverCosts costs = Coupled::costs;
            if constexpr (costs.linear > 0) {
                if (way == Way::linear) {
                    return corrected_.template solve<false>(coupled, coupled.linear,
                                                            {costs.linear, 0, most});
                }
            }
            return corrected_.template solve<true>(coupled, coupled.corrections,
                                                   {costs.correction, costs.factors, most});
        }

        template <class Coupled>
        [[nodiscard, gnu::noinline, gnu::cold]] Status solve_stiff(Coupled coupled) {
            return newton_.solve(coupled);
        }

        FixedPoint::template Iteration<Vector> sweeps_;
        typename Newton::template Corrected<Vector> corrected_;
        typename Newton::template Iteration<Vector> newton_;
        Way usual_ = Way::sweeps;      ///< the way that has cost least
        Way other_ = Way::corrected;   ///< the way that is tried next
        int cost_ = 0;                 ///< of the last step that decides; 0: not known
        Scalar largest_ = 0;           ///< largest step size so far: steps of it decide
        bool decides_ = true;          ///< whether the present step decides
        int cheap_ = 0;                ///< see cheap(); for sweeps from extrapolated slopes
        int cost_from_start_ = 0;      ///< of the last step that began with slopes at its start
        detail::Pause<8> other_way_;   ///< steps until another way is tried
        detail::Pause<1> others_;      ///< steps while Newton's method alone is used
        detail::Pause<1> from_start_;  ///< steps while slopes at the start are the better ones
    };
};

}  // namespace hvi
