// Sweeps whose slopes are corrected.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/solvers/end_of_corrections.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Sweeps whose slopes are corrected, down to round-off. `Corrections` computes factors, and with
/// these corrects the slopes at the present stages.
template <class Vector>
class CorrectedSweeps {
public:
    using Scalar = ScalarOf<Vector>;

    /// Rule for computing new factors.
    enum class Renewal {
        where_slow,  ///< where corrections contract slowly; growing changes are given up
        eager,       ///< after the first correction and wherever corrections do not contract
        never,       ///< where corrections do not contract they are given up
    };
    struct Terms {
        int iteration, factors;  ///< costs of one iteration and of factors
        int most;                ///< limit on the total cost
        Renewal renewal = Renewal::where_slow;
    };

    /// Solves the equations. The status is singular where no factors can be computed, for whatever
    /// reason. With `keeps_factors` the factors are kept from step to step while h stays, and
    /// renewed; otherwise they depend on h alone. Preconditions: those of Sweeps.
    template <bool keeps_factors, class Coupled, class Corrections>
    [[nodiscard]] Status solve(Coupled& coupled, Corrections& corrections, const Terms& terms) {
        coupled.begin_corrections();
        end_.begin(coupled.s.n);
        spent_ = 0;
        const auto factorise = [&] {
            spent_ += terms.factors;
            return corrections.factorise(coupled);
        };
        bool has_factors = (keeps_factors && factored_ == coupled.s.h) || factorise();
        bool is_last = false;
        bool is_finite = true;
        int iteration = 0;
        while (has_factors && spent_ < terms.most) {
            ++iteration;
            spent_ += terms.iteration;
            corrections.correct(coupled);
            // NOTE: the stages do not show errors of the slopes below their own rounding, and these
            // errors have the sign of the starting values' error: without the last correction the
            // energy of Kepler's problem drifted by 4e-19 a step.
            if (is_last) {
                if constexpr (keeps_factors) { factored_ = coupled.s.h; }
                return Status(Status::Code::ok, iteration);
            }
            coupled.momenta();
            coupled.positions();
            const Now now = end_.judge(coupled);
            is_last = now == Now::ended || end_.next_is_last();
            is_finite = now != Now::not_finite;
            const bool is_eager = terms.renewal == Renewal::eager;
            if (!is_finite || (!is_eager && end_.grows(coupled))) { break; }
            if (is_last || !keeps_factors) { continue; }
            if (end_.contracts() && !(is_eager && iteration == 1)) { continue; }
            if (terms.renewal == Renewal::never) { break; }
            has_factors = factorise();
        }
        if constexpr (keeps_factors) { factored_ = 0; }
        return Status(!has_factors                   ? Status::Code::singular
                      : !is_finite && iteration == 1 ? Status::Code::not_finite
                                                     : Status::Code::not_converged,
                      iteration);
    }

    /// Returns the cost of the last solve().
    [[nodiscard]] int spent() const { return spent_; }

    void forget() { factored_ = 0; }
    void assume_factors(Scalar h) { factored_ = h; }

private:
    using Now = typename EndOfCorrections<Vector>::Now;

    EndOfCorrections<Vector> end_;
    Scalar factored_ = 0;  ///< step size of the factors; 0: there are none
    int spent_ = 0;
};

}  // namespace hvi::detail
