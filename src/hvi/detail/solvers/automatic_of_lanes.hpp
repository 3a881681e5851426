// Fixed points or Newton's corrections, whichever is cheaper, for stages in lanes.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/solvers/end_of_corrections.hpp>
#include <hvi/detail/solvers/pause.hpp>
#include <hvi/fixed_point.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// What the ways to solve the equations of the stages cost, in one unit; computed when the header
/// is written.
struct SolverCosts {
    int sweep;       ///< of fixed points
    int linear;      ///< of those whose linear part is solved exactly; 0: H has none
    int correction;  ///< a sweep and a correction of its slopes
    int factors;     ///< of the Jacobian with one Hessian
};

/// Sweeps whose slopes are corrected, down to round-off. `Corrections` have factors to compute, and
/// with these correct the slopes at the present stages.
template <class Vector>
class CorrectedSweeps {
public:
    /// Gives up after `most`. `keeps_factors`: from step to step, and they are computed anew where
    /// corrections do not contract; else they depend on h alone. Preconditions: those of Sweeps.
    template <bool keeps_factors, class Coupled, class Corrections>
    [[nodiscard]] Status solve(Coupled& coupled, Corrections& corrections, int most) {
        coupled.begin_corrections();
        end_.begin(coupled.s.n);
        bool has_new_factors = !keeps_factors || !has_factors_;
        bool has_factors = (keeps_factors && has_factors_) || corrections.factorise(coupled);
        bool is_last = false;
        for (int iteration = 1; has_factors && iteration <= most; ++iteration) {
            corrections.correct(coupled);
            // NOTE: the stages do not show what is left in the slopes below their own rounding,
            // which has the sign of the starting values' error: without the last correction the
            // energy of Kepler's problem drifted by 4e-19 a step.
            if (is_last) {
                if constexpr (keeps_factors) { has_factors_ = true; }
                return Status(Status::Code::ok, iteration);
            }
            coupled.momenta();
            coupled.positions();
            const Now now = end_.judge(coupled);
            is_last = now == Now::ended;
            if (now == Now::not_finite || end_.grows(coupled)) { break; }
            if (is_last || !keeps_factors || end_.contracts()) { continue; }
            if (has_new_factors) { break; }
            has_factors = corrections.factorise(coupled);
            has_new_factors = true;
        }
        if constexpr (keeps_factors) { has_factors_ = false; }
        return Status(Status::Code::not_converged, most);
    }

    void forget() { has_factors_ = false; }

private:
    using Now = typename EndOfCorrections<Vector>::Now;

    EndOfCorrections<Vector> end_;
    bool has_factors_ = false;
};

}  // namespace detail

/// Solver policy of steppers whose stages are lanes: fixed points, those whose linear part is
/// solved exactly, or corrections with one Hessian for all stages, whichever have cost least on the
/// steps before, and `Newton` where all fail. What has not been the cheapest is tried again after
/// 8, 16, 32, 64, 64, ... steps, for as long as it costs no more. All solve the equations to
/// round-off, so that a change from one to the other does not show in the energy.
///
/// Costs are counts of iterations times numbers of the header, so that the same steps are solved in
/// the same way on every machine.
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
            if (!coupled.s.continues || coupled.s.h != coupled.s.h_before) { forget(costs); }
            from_start_.pass();
            other_way_.pass();
            others_.pass();
            if (!others_.is_over()) { return solve_stiff(coupled); }
            int iterations = 0;
            for (Attempt now = first(costs); now.way != Way::newton; now = after(now, costs)) {
                if (now.is_from_start) { coupled.predict(); }
                const int most = most_iterations(now, costs);
                const Status status = now.way == Way::sweeps
                                          ? sweeps_.template solve<true>(coupled, most)
                                          : solve_corrected(coupled, now.way, most);
                iterations += status.iterations;
                if (status.ok()) {
                    learn(now, cost(now.way, status.iterations, costs), costs);
                    return Status(Status::Code::ok, iterations);
                }
            }
            others_.begin();
            return solve_stiff(coupled);
        }

    private:
        enum class Way { sweeps, linear, corrected, newton };
        /// What a step tries.
        struct Attempt {
            Way way;
            bool is_from_start;     ///< with slopes as at the start of the step
            bool is_trial = false;  ///< of a way that has not been the cheapest
        };
        static constexpr int most_corrections = 25;

        [[nodiscard]] static constexpr int cost(Way way, int iterations,
                                                const detail::SolverCosts& costs) {
            switch (way) {
            case Way::sweeps: return iterations * costs.sweep;
            case Way::linear: return iterations * costs.linear;
            case Way::corrected: return costs.factors + iterations * costs.correction;
            case Way::newton: break;
            }
            return 0;
        }

        [[nodiscard]] Attempt first(const detail::SolverCosts& costs) const {
            constexpr int least = 6;  // iterations
            const bool is_from_start = !from_start_.is_over();
            if (cost_ > cost(other_, least, costs) && other_way_.is_over()) {
                return {other_, is_from_start, true};
            }
            return {usual_, is_from_start};
        }

        /// What follows on an attempt that failed.
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
            usual_ = ended.way;
            cost_ = cost;
            others_.forget();
            if (is_new) {
                other_way_.forget();
                has_tried(costs);
            } else if (!ended.is_from_start) {
                from_start_.forget();
            } else if (from_start_.is_over()) {
                from_start_.begin();
            }
        }

        /// The next trial is of another way.
        void has_tried(const detail::SolverCosts& costs) {
            other_way_.begin();
            do {
                other_ = other_ == Way::sweeps   ? Way::linear
                         : other_ == Way::linear ? Way::corrected
                                                 : Way::sweeps;
            } while (other_ == usual_ || (other_ == Way::linear && costs.linear == 0));
        }

        /// NOTE: what is tried may cost as much as what is known.
        [[nodiscard]] int most_iterations(const Attempt& now,
                                          const detail::SolverCosts& costs) const {
            const int most = now.is_trial ? cost_ : cost(Way::corrected, most_corrections, costs);
            switch (now.way) {
            case Way::sweeps: return most / costs.sweep;
            case Way::linear: return most / costs.linear;
            case Way::corrected: return (most - costs.factors) / costs.correction;
            case Way::newton: break;
            }
            return 0;
        }

        void forget(const detail::SolverCosts& costs) {
            usual_ = other_ = Way::sweeps;
            cost_ = 0;
            from_start_.forget();
            other_way_.forget();
            others_.forget();
            has_tried(costs);
            corrected_.forget();
        }

        // NOTE: both apart, so that compilers keep the registers of sweeps for themselves.
        template <class Coupled>
        [[nodiscard, gnu::noinline]] Status solve_corrected(Coupled& coupled,
                                                            [[maybe_unused]] Way way, int most) {
            if constexpr (Coupled::costs.linear > 0) {
                if (way == Way::linear) {
                    return corrected_.template solve<false>(coupled, coupled.linear, most);
                }
            }
            return corrected_.template solve<true>(coupled, coupled.corrections, most);
        }

        template <class Coupled>
        [[nodiscard, gnu::noinline, gnu::cold]] Status solve_stiff(Coupled coupled) {
            return newton_.solve(coupled);
        }

        FixedPoint::template Iteration<Vector> sweeps_;
        detail::CorrectedSweeps<Vector> corrected_;
        typename Newton::template Iteration<Vector> newton_;
        Way usual_ = Way::sweeps;      ///< the one that has cost least
        Way other_ = Way::corrected;   ///< that is tried next
        int cost_ = 0;                 ///< of the last step, by the usual one; 0: not known
        detail::Pause<8> other_way_;   ///< until then
        detail::Pause<1> others_;      ///< while Newton's method alone is used
        detail::Pause<1> from_start_;  ///< while the slopes at the start are the better ones
    };
};

}  // namespace hvi
