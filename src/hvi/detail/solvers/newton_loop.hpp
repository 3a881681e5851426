// When Newton's method corrects, when it factors anew, and when it ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/round_off.hpp>
#include <hvi/detail/stages/system.hpp>
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
/// both factorisations false where J is singular or not finite. The factors are kept over
/// iterations and steps while the iteration contracts well. They are forgotten with the state that
/// they belong to and when h changes.
///
/// NOTE: it starts from no slopes, not from extrapolated ones: no polynomial follows a solution
/// whose period is short against h, and q, p is where H is sure to be defined.
template <class Vector, class Equations>
class NewtonLoop {
public:
    static constexpr int most_iterations = 60;

    template <class Coupled>
    [[nodiscard]] Status solve(Coupled coupled) {
        if (equations_.fit(coupled)) { factored_ = false; }
        round_off_.begin(coupled.s.n);
        equations_.begin(coupled);
        const bool reusable = factored_ && coupled.s.continues && coupled.s.h == coupled.s.h_before;
        factored_ = reusable || equations_.factorise_start(coupled);
        if (!factored_) { return no_factors(0); }

        bool reused = reusable;
        Scalar last_change = 0;
        Scalar smallest_change = infinity<Scalar>;
        int stalls = 0;  // corrections in a row that were not smaller than all before
        for (int iteration = 1; iteration <= most_iterations; ++iteration) {
            equations_.correct(coupled);
            switch (round_off_.template judge<Coupled::has_q, Coupled::has_p>(coupled.s.change,
                                                                              coupled)) {
            case Verdict::go_on: break;
            case Verdict::unchanged:
            case Verdict::at_noise: return Status(Status::Code::ok, iteration);
            case Verdict::not_finite: return failed(iteration);
            }
            const Scalar change = relative_change(coupled);
            const bool falls = iteration == 1 || 8 * change < 7 * last_change;
            const bool contracts = iteration == 1 || 4 * change <= last_change;
            last_change = change;
            if (!falls && change <= rounding) { return Status(Status::Code::ok, iteration); }
            stalls = change < smallest_change ? 0 : stalls + 1;
            smallest_change = change < smallest_change ? change : smallest_change;
            if (stalls >= patience && change <= noise) {
                return Status(Status::Code::ok, iteration);
            }
            if (contracts || change <= well) { continue; }
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
    using Scalar = ScalarOf<Vector>;
    // NOTE: the part of a value that a correction may be and pass for rounding: it is rounding
    // times the inverse of J, which may magnify it somewhat. A correction below it ends the
    // iteration only when corrections no longer fall (Hairer, McLachlan & Razakarivony 2008), by an
    // eighth: parts of the last bit may creep for a hundred iterations, each a little smaller.
    // To end at the first one below 4 epsilon, or where the rate of contraction promised a
    // next one below 2^-58, made the energy of Kepler's problem drift.
    static constexpr Scalar rounding = 128 * epsilon<Scalar>;
    // Components that are small beside those they are coupled with may be left with more than that:
    // after so many corrections that got no smaller, those below this part are rounding as well.
    static constexpr int patience = 6;
    static constexpr Scalar noise = power_of_two<Scalar>(-3 * bits<Scalar> / 4);
    // So near to the solution any contraction does: with half of the digits and some more.
    static constexpr Scalar well = power_of_two<Scalar>(-4 * bits<Scalar> / 7);

    [[nodiscard]] Status no_factors(int iteration) const {
        return Status(equations_.is_finite() ? Status::Code::singular : Status::Code::not_finite,
                      iteration);
    }

    [[nodiscard]] Status failed(int iteration) {
        factored_ = false;
        return Status(iteration == 1 ? Status::Code::not_finite : Status::Code::not_converged,
                      iteration);
    }

    /// What the last correction changed, as a part of the values: of each component, or of the
    /// largest where J is solved by products with it, whose rounding is that of the largest.
    template <class Coupled>
    [[nodiscard]] Scalar relative_change(const Coupled& coupled) const {
        if (equations_.rounds_with_largest()) { return change_of_largest(coupled); }
        Scalar largest = 0;
        const auto look = [&](Scalar change, Scalar size) {
            if (change != 0) { largest = larger(largest, change / size); }
        };
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            if constexpr (Coupled::has_q) { look(coupled.s.change.q[k], coupled.size_q(k)); }
            if constexpr (Coupled::has_p) { look(coupled.s.change.p[k], coupled.size_p(k)); }
        }
        return largest;
    }

    template <class Coupled>
    [[nodiscard]] static Scalar change_of_largest(const Coupled& coupled) {
        Scalar change = 0, size = 0;
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            if constexpr (Coupled::has_q) {
                change = larger(change, coupled.s.change.q[k]);
                size = larger(size, coupled.size_q(k));
            }
            if constexpr (Coupled::has_p) {
                change = larger(change, coupled.s.change.p[k]);
                size = larger(size, coupled.size_p(k));
            }
        }
        return change > 0 ? change / size : Scalar(0);
    }

    RoundOff<Vector> round_off_{rounding};
    Equations equations_;
    bool factored_ = false;
};

}  // namespace hvi::detail
