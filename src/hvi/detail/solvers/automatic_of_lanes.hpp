// Fixed points or Newton's corrections, whichever is cheaper, for stages in lanes.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/solvers/end_of_corrections.hpp>
#include <hvi/fixed_point.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// What the ways to solve the equations of the stages cost, in one unit; computed when the header
/// is written.
struct SolverCosts {
    int sweep;       ///< of fixed points
    int correction;  ///< a sweep and a correction of its slopes
    int factors;     ///< of the Jacobian with one Hessian
};

/// Sweeps whose slopes are corrected with one Hessian for all stages, down to round-off.
template <class Vector>
class CorrectedSweeps {
public:
    /// Gives up after `most`, or where corrections with new factors do not contract.
    /// Preconditions: those of Sweeps.
    template <class Coupled>
    [[nodiscard]] Status solve(Coupled& coupled, int most) {
        coupled.begin_corrections();
        end_.begin(coupled.s.n);
        bool has_new_factors = !has_factors_;
        has_factors_ = has_factors_ || coupled.corrections.factorise(coupled);
        for (int iteration = 1; has_factors_ && iteration <= most; ++iteration) {
            coupled.corrections.correct(coupled);
            coupled.momenta();
            coupled.positions();
            switch (end_.judge(coupled)) {
            case Now::go_on: break;
            case Now::ended: return Status(Status::Code::ok, iteration);
            case Now::not_finite: has_factors_ = false; break;
            }
            if (end_.contracts() || !has_factors_) { continue; }
            if (has_new_factors) { break; }
            has_factors_ = coupled.corrections.factorise(coupled);
            has_new_factors = true;
        }
        has_factors_ = false;
        return Status(Status::Code::not_converged, most);
    }

    void forget() { has_factors_ = false; }
    [[nodiscard]] bool has_factors() const { return has_factors_; }

private:
    using Now = typename EndOfCorrections<Vector>::Now;

    EndOfCorrections<Vector> end_;
    bool has_factors_ = false;
};

/// For how many steps what has failed is not tried again: `shortest` and twice, four times, ... 64
/// as it goes on to fail.
template <int shortest>
class Pause {
public:
    [[nodiscard]] bool is_over() const { return left_ == 0; }
    void pass() { left_ -= left_ > 0 ? 1 : 0; }
    void begin() {
        left_ = next_;
        next_ = next_ < longest ? 2 * next_ : next_;
    }
    void forget() { *this = Pause(); }

private:
    static constexpr int longest = 64;
    int left_ = 0, next_ = shortest;
};

}  // namespace detail

/// Solver policy of steppers whose stages are lanes: fixed points, or corrections with one Hessian
/// for all stages, whichever have cost less on the steps before, and `Newton` where both fail. What
/// has not been the cheaper one is tried again after 8, 16, 32, 64, 64, ... steps, for as long as
/// it costs no more. All solve the equations to round-off, so that a change from one to the other
/// does not show in the energy.
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
            if (!coupled.s.continues || coupled.s.h != coupled.s.h_before) { forget(); }
            from_start_.pass();
            other_way_.pass();
            int iterations = 0;
            for (Try now = first_try(costs); now != Try::newton; now = next(now)) {
                if (begins_at_start(now)) { coupled.predict(); }
                const bool is_corrected = takes_corrections(now);
                const int most = most_iterations(now, costs);
                const Status status =
                    is_corrected ? solve_corrected(coupled, most) : sweeps_.solve(coupled, most);
                iterations += status.iterations;
                if (status.ok()) {
                    learn(now, cost(is_corrected, status.iterations, costs));
                    return Status(Status::Code::ok, iterations);
                }
                if (now == Try::other) { other_way_.begin(); }
            }
            cost_ = 0;
            return solve_stiff(coupled);
        }

    private:
        /// What a step tries in turn.
        enum class Try {
            other,             ///< the way that has not been the cheaper one
            usual,             ///< the cheaper one
            usual_from_start,  ///< from slopes as at the start of the step
            other_from_start,
            newton
        };
        static constexpr int most_corrections = 25;

        [[nodiscard]] Try first_try(const detail::SolverCosts& costs) const {
            constexpr int least_corrections = 6;
            const bool may_be_cheaper =
                is_corrected_ || cost_ > cost(true, least_corrections, costs);
            if (cost_ > 0 && other_way_.is_over() && may_be_cheaper) { return Try::other; }
            return from_start_.is_over() ? Try::usual : Try::usual_from_start;
        }

        [[nodiscard]] static Try next(Try failed) {
            switch (failed) {
            case Try::other:
            case Try::usual: return Try::usual_from_start;
            case Try::usual_from_start: return Try::other_from_start;
            case Try::other_from_start:
            case Try::newton: break;
            }
            return Try::newton;
        }

        [[nodiscard]] bool begins_at_start(Try now) const {
            return now == Try::usual_from_start || now == Try::other_from_start ||
                   (now == Try::other && !from_start_.is_over());
        }

        [[nodiscard]] bool takes_corrections(Try now) const {
            const bool is_other = now == Try::other || now == Try::other_from_start;
            return is_other != is_corrected_;
        }

        [[nodiscard]] static constexpr int cost(bool is_corrected, int iterations,
                                                const detail::SolverCosts& costs) {
            return is_corrected ? costs.factors + iterations * costs.correction
                                : iterations * costs.sweep;
        }

        /// NOTE: what is tried may cost as much again as what is known.
        [[nodiscard]] int most_iterations(Try now, const detail::SolverCosts& costs) const {
            const bool is_corrected = takes_corrections(now);
            if (now == Try::other) {
                return is_corrected ? (cost_ - costs.factors) / costs.correction
                                    : cost_ / costs.sweep;
            }
            return is_corrected ? most_corrections
                                : cost(true, most_corrections, costs) / costs.sweep;
        }

        void learn(Try now, int cost) {
            switch (now) {
            case Try::other:
                if (cost < cost_) {
                    is_corrected_ = !is_corrected_;
                    cost_ = cost;
                    other_way_.forget();
                }
                other_way_.begin();
                return;
            case Try::usual_from_start:
                if (from_start_.is_over()) { from_start_.begin(); }
                break;
            case Try::other_from_start:
                is_corrected_ = !is_corrected_;
                other_way_.begin();
                break;
            case Try::usual: from_start_.forget(); break;
            case Try::newton: break;
            }
            cost_ = cost;
        }

        void forget() {
            is_corrected_ = false;
            cost_ = 0;
            from_start_.forget();
            other_way_.forget();
            other_way_.begin();
            corrected_.forget();
        }

        // NOTE: both apart, so that compilers keep the registers of sweeps for themselves.
        template <class Coupled>
#if defined(__GNUC__)
        [[gnu::noinline]]
#endif
        [[nodiscard]] Status
        solve_corrected(Coupled& coupled, int most) {
            return corrected_.solve(coupled, most);
        }

        template <class Coupled>
#if defined(__GNUC__)
        [[gnu::noinline, gnu::cold]]
#endif
        [[nodiscard]] Status
        solve_stiff(Coupled coupled) {
            return newton_.solve(coupled);
        }

        FixedPoint::template Iteration<Vector> sweeps_;
        detail::CorrectedSweeps<Vector> corrected_;
        typename Newton::template Iteration<Vector> newton_;
        bool is_corrected_ = false;    ///< the way that has cost less
        int cost_ = 0;                 ///< of the last step, by it; 0: not known
        detail::Pause<8> other_way_;   ///< until the other one is tried
        detail::Pause<1> from_start_;  ///< while the slopes at the start are the better ones
    };
};

}  // namespace hvi
