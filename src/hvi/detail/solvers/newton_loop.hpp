// When Newton's method corrects, when it factors anew, and when it ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/solvers/end_of_corrections.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Newton's method down to round-off. `Equations` has the unknowns of one step and the factors of
/// their Jacobian J, and offers
///
///     bool fit(coupled);                   makes room; true where there was not enough
///     void begin(coupled);                 starts from no slopes at all
///     bool factorise_start(coupled);       factors of J as begin() leaves the stages
///     bool factorise(coupled);             factors of J at the present stages
///     void correct(coupled);               unknowns -= J^-1 residual, and sets coupled.s.change
///     bool is_finite();                    whether J was, or should have been
///     bool rounds_with_largest();          whether no component of a correction is righter than
///                                          the largest one
///
/// Both factorisations return false where J is singular or not finite. The factors are kept over
/// iterations and steps while the iteration contracts well. They are dropped when h changes, and
/// when a step does not begin where the last one ended.
///
/// NOTE: the iteration starts from no slopes, not from extrapolated ones: no polynomial follows a
/// solution whose period is short against h, and q, p is a point where H is sure to be defined.
template <class Vector, class Equations>
class NewtonLoop {
public:
    static constexpr int most_iterations = 60;

    template <class Coupled>
    [[nodiscard]] Status solve(Coupled coupled) {
        if (equations_.fit(coupled)) { factored_ = false; }
        end_.begin(coupled.s.n);
        equations_.begin(coupled);
        const bool reusable = factored_ && coupled.s.h == coupled.s.h_before;
        factored_ = reusable || equations_.factorise_start(coupled);
        if (!factored_) { return no_factors(0); }

        bool reused = reusable;
        for (int iteration = 1; iteration <= most_iterations; ++iteration) {
            equations_.correct(coupled);
            switch (end_.judge(coupled, equations_.rounds_with_largest())) {
            case Now::go_on: break;
            case Now::ended: return Status(Status::Code::ok, iteration);
            case Now::not_finite: return failed(iteration);
            }
            if (end_.contracts()) { continue; }
            if (reused) { equations_.begin(coupled); }
            factored_ =
                reused ? equations_.factorise_start(coupled) : equations_.factorise(coupled);
            if (!factored_) { return no_factors(iteration); }
            reused = false;
        }
        factored_ = false;
        return Status(Status::Code::not_converged, most_iterations);
    }

private:
    using Now = typename EndOfCorrections<Vector>::Now;

    [[nodiscard]] Status no_factors(int iteration) const {
        return Status(equations_.is_finite() ? Status::Code::singular : Status::Code::not_finite,
                      iteration);
    }

    [[nodiscard]] Status failed(int iteration) {
        factored_ = false;
        return Status(iteration == 1 ? Status::Code::not_finite : Status::Code::not_converged,
                      iteration);
    }

    EndOfCorrections<Vector> end_;
    Equations equations_;
    bool factored_ = false;
};

}  // namespace hvi::detail
