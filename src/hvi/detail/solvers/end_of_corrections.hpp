// When Newton's corrections have come to round-off, and when they go too slowly.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/round_off.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Watches the corrections of one step.
template <class Vector>
class EndOfCorrections {
public:
    enum class Now { go_on, ended, not_finite };

    void begin(IndexOf<Vector> n) {
        round_off_.begin(n);
        is_first_ = true;
        contracts_ = true;
        next_is_last_ = false;
        smallest_change_ = infinity<Scalar>;
        stalls_ = 0;
    }

    /// Judges one correction by its change, coupled.s.change, relative to the values: of each
    /// component, or of the largest one where no component is more accurate than the largest.
    template <class Coupled>
    [[nodiscard]] Now judge(const Coupled& coupled, bool by_largest = false) {
        switch (
            round_off_.template judge<Coupled::has_q, Coupled::has_p>(coupled.s.change, coupled)) {
        case Verdict::go_on: break;
        case Verdict::unchanged:
        case Verdict::at_noise: return Now::ended;
        case Verdict::not_finite: return Now::not_finite;
        }
        const Scalar change =
            by_largest ? change_of_largest(coupled) : largest_relative_change(coupled);
        const bool falls = is_first_ || 8 * change < 7 * last_change_;
        next_is_last_ = !is_first_ && change <= nearly && change <= fast * last_change_;
        contracts_ = is_first_ || 4 * change <= last_change_ || change <= well;
        is_first_ = false;
        last_change_ = change;
        if (!falls && change <= rounding) { return Now::ended; }
        stalls_ = change < smallest_change_ ? 0 : stalls_ + 1;
        smallest_change_ = change < smallest_change_ ? change : smallest_change_;
        return stalls_ >= patience && change <= noise ? Now::ended : Now::go_on;
    }

    /// Returns whether the corrections grow; see RoundOff.
    template <class Coupled>
    [[nodiscard]] bool grows(const Coupled& coupled) const {
        return round_off_.template grows<Coupled::has_q, Coupled::has_p>(coupled.s.change, coupled);
    }

    /// Returns whether the next correction changes the slopes far below rounding, and leaves an
    /// error that is smaller by the same factor.
    ///
    /// NOTE: the next correction is applied nevertheless; see CorrectedSweeps.
    [[nodiscard]] bool next_is_last() const { return next_is_last_; }

    /// Returns whether the last correction was small enough beside the one before.
    [[nodiscard]] bool contracts() const { return contracts_; }

private:
    using Scalar = ScalarOf<Vector>;
    // NOTE: the largest relative change that may pass for rounding: rounding times the inverse of
    // J, which may magnify it somewhat. A correction below it ends the iteration only when
    // corrections no longer fall (Hairer, McLachlan & Razakarivony 2008), by an eighth: parts of
    // the last bit may creep for a hundred iterations, each a little smaller. Ending at the first
    // correction below 4 epsilon, or where the rate of contraction promised a next one below 2^-58,
    // made the energy of Kepler's problem drift.
    static constexpr Scalar rounding = 128 * epsilon<Scalar>;
    // Components that are small beside those they are coupled with may keep larger changes. After
    // this many corrections that got no smaller, changes below this part are rounding as well.
    static constexpr int patience = 6;
    static constexpr Scalar noise = power_of_two<Scalar>(-3 * bits<Scalar> / 4);
    // Changes this small are near enough to the solution for any contraction to be fast enough:
    // half of the digits and some more.
    static constexpr Scalar well = power_of_two<Scalar>(-4 * bits<Scalar> / 7);
    static constexpr Scalar far = power_of_two<Scalar>(-4);
    // At a change below 4 epsilon that fell this fast, the next change is below 2^-58 of a double,
    // and the one after it below 2^-66.
    static constexpr Scalar nearly = 4 * epsilon<Scalar>, fast = power_of_two<Scalar>(-8);

    /// NOTE: sizes are taken from the last stages that were still far from the solution: near to it
    /// they hardly change.
    template <class Coupled>
    [[nodiscard]] Scalar largest_relative_change(const Coupled& coupled) {
        if (is_first_ || last_change_ > far) { measure(coupled); }
        const State<Vector>& change = coupled.s.change;
        Scalar largest = 0;
        const auto look = [&](Scalar part) { largest = part > largest ? part : largest; };
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            if constexpr (Coupled::has_q) { look(part_of(change.q[k], part_.q[k])); }
            if constexpr (Coupled::has_p) { look(part_of(change.p[k], part_.p[k])); }
        }
        return largest;
    }

    [[nodiscard]] static Scalar part_of(Scalar change, Scalar inverse_size) {
        return change != 0 ? change * inverse_size : Scalar(0);
    }

    template <class Coupled>
    void measure(const Coupled& coupled) {
        fit(part_.q, coupled.s.n);
        fit(part_.p, coupled.s.n);
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            if constexpr (Coupled::has_q) { part_.q[k] = 1 / coupled.size_q(k); }
            if constexpr (Coupled::has_p) { part_.p[k] = 1 / coupled.size_p(k); }
        }
    }

    /// Returns the change of the largest component, relative to it. NOTE: positions and momenta
    /// have units of their own.
    template <class Coupled>
    [[nodiscard]] static Scalar change_of_largest(const Coupled& coupled) {
        Scalar change_q = 0, size_q = 0, change_p = 0, size_p = 0;
        for (IndexOf<Vector> k = 0; k < coupled.s.n; ++k) {
            if constexpr (Coupled::has_q) {
                change_q = larger(change_q, coupled.s.change.q[k]);
                size_q = larger(size_q, coupled.size_q(k));
            }
            if constexpr (Coupled::has_p) {
                change_p = larger(change_p, coupled.s.change.p[k]);
                size_p = larger(size_p, coupled.size_p(k));
            }
        }
        return larger(change_q > 0 ? change_q / size_q : Scalar(0),
                      change_p > 0 ? change_p / size_p : Scalar(0));
    }

    RoundOff<Vector> round_off_{rounding};
    State<Vector> part_;  ///< 1/size of each component, see RoundOff::judge()
    Scalar last_change_ = 0, smallest_change_ = infinity<Scalar>;
    int stalls_ = 0;  ///< corrections in a row that were not smaller than all before
    bool is_first_ = true, contracts_ = true, next_is_last_ = false;
};

}  // namespace hvi::detail
