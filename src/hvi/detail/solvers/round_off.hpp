// The end of an iteration at round-off.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

enum class Verdict {
    go_on,
    unchanged,  ///< no bit changes any more
    at_noise,   ///< the changes that remain are rounding
    not_finite,
};

/// Watches the changes of an iteration and ends it at round-off, not at a tolerance: a tolerance
/// biases the error, and then the energy drifts (Hairer, McLachlan & Razakarivony 2008).
///
/// The rule is that of Antonana, Makazaga & Murua: go on while some component still changes by less
/// than ever before, allow one more sweep, then stop. NOTE: a change that no longer falls may also
/// belong to an iteration that diverges, or circles while it converges. So the rule ends an
/// iteration only when the changes are no more than rounding of the values themselves. Changes that
/// stay larger for `patience` sweeps pass for the noise of a gradient with cancellation if they are
/// tiny against the largest component. Otherwise the iteration goes on to its cap.
template <class Vector>
class RoundOff {
public:
    using Index = IndexOf<Vector>;
    using Scalar = ScalarOf<Vector>;

    /// `rounding`: the largest relative change that may pass for rounding.
    explicit RoundOff(Scalar rounding) : rounding_(rounding) {}

    void begin(Index n) {
        fit(smallest_.q, n);
        fit(smallest_.p, n);
        for (Index k = 0; k < n; ++k) {
            smallest_.q[k] = infinity<Scalar>;
            smallest_.p[k] = infinity<Scalar>;
        }
        smallest_total_ = infinity<Scalar>;
        unit_ = 0;
        stalls_ = 0;
    }

    /// Judges one sweep by its changes of q, of p or of both. `coupled.size_q(k)` is the sum of the
    /// absolute values whose rounding shows in component k of `change.q`; coupled.size_p(k) is that
    /// for p.
    template <bool by_q, bool by_p, class Coupled>
    [[nodiscard]] Verdict judge(const State<Vector>& change, const Coupled& coupled) {
        Seen seen;
        if constexpr (by_q) { look(change.q, smallest_.q, seen); }
        if constexpr (by_p) { look(change.p, smallest_.p, seen); }
        if (!(seen.total < infinity<Scalar>)) { return Verdict::not_finite; }
        total_ = seen.total;
        if (seen.total == 0) { return Verdict::unchanged; }
        smallest_total_ = total_ < smallest_total_ ? total_ : smallest_total_;
        stalls_ = seen.falls != 0 ? 0 : stalls_ + 1;
        if (stalls_ < 2) { return Verdict::go_on; }
        return is_noise<by_q, by_p>(change, coupled) ? Verdict::at_noise : Verdict::go_on;
    }

    /// Returns whether the last sweep that was judged changed so much more than an earlier one that
    /// the iteration is worth giving up, where there are other ways to solve the step.
    template <bool by_q, bool by_p, class Coupled>
    [[nodiscard]] bool grows(const State<Vector>& change, const Coupled& coupled) const {
        return total_ > growth * smallest_total_ && !is_noise<by_q, by_p>(change, coupled);
    }

    /// Returns whether the last sweep that was judged changed all components together by no more
    /// than half a unit in their last places.
    template <bool by_q, bool by_p, class Coupled>
    [[nodiscard]] bool is_near(const Coupled& coupled) {
        if (unit_ == 0) {
            for (Index k = 0; k < coupled.s.n; ++k) {
                if constexpr (by_q) { unit_ += epsilon<Scalar> / 2 * coupled.size_q(k); }
                if constexpr (by_p) { unit_ += epsilon<Scalar> / 2 * coupled.size_p(k); }
            }
        }
        return total_ <= unit_;
    }

private:
    static constexpr Scalar noise = power_of_two<Scalar>(-(3 * bits<Scalar> + 3) / 4);
    static constexpr int patience = 10;
    // NOTE: for x' = L x the changes of Picard's iteration are (h L)^k/k!. For h L = 8 they grow by
    // this factor before they fall: there a step is slower than two of half its length.
    static constexpr Scalar growth = 64;

    struct Seen {
        Scalar total = 0;  // a sum, so that a NaN cannot hide
        int falls = 0;
    };

    static void look(const Vector& change, Vector& smallest, Seen& seen) {
        for (Index k = 0; k < change.size(); ++k) {
            // NOTE: no branch here: which components fall is noise, which no processor predicts.
            seen.total += change[k];
            seen.falls |=
                static_cast<int>(change[k] > 0) & static_cast<int>(change[k] < smallest[k]);
            smallest[k] = change[k] < smallest[k] ? change[k] : smallest[k];
        }
    }

    template <bool by_q, bool by_p, class Coupled>
    [[nodiscard]] bool is_noise(const State<Vector>& change, const Coupled& coupled) const {
        bool by_component = true;
        bool by_norm = true;
        const auto compare = [&](const Vector& changes, auto size) {
            Scalar largest_change = 0;
            Scalar largest_size = 0;
            for (Index k = 0; k < changes.size(); ++k) {
                by_component &= changes[k] <= rounding_ * size(k);
                largest_change = larger(largest_change, changes[k]);
                largest_size = larger(largest_size, size(k));
            }
            by_norm &= largest_change <= noise * largest_size;
        };
        if constexpr (by_q) {
            compare(change.q, [&](Index k) { return coupled.size_q(k); });
        }
        if constexpr (by_p) {
            compare(change.p, [&](Index k) { return coupled.size_p(k); });
        }
        return by_component || (by_norm && stalls_ >= patience);
    }

    Scalar rounding_;
    Scalar total_ = 0, smallest_total_ = infinity<Scalar>;  // change of all components, and so far
    Scalar unit_ = 0;                                       // see is_near(); 0: not known
    State<Vector> smallest_;                                // change of each component so far
    int stalls_ = 0;  // sweeps in a row in which no component changed by less than ever
};

}  // namespace hvi::detail
