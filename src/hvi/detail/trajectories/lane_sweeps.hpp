// Fixed-point iteration for trajectories side by side: each ends where it would alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/solvers/joint_slopes.hpp>
#include <hvi/detail/solvers/sweep.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi::detail {

/// RoundOff of each lane.
template <class Number, std::size_t dimension>
class LaneRoundOff {
public:
    using Lane = Lanes<Number, trajectories_at_once>;
    using Mask = typename Lane::Mask;
    using Changes = LaneRows<Number, trajectories_at_once, dimension>;

    /// Lanes of each verdict; in the others the iteration goes on.
    struct Verdicts {
        Mask unchanged, at_noise, not_finite;
    };

    void begin() {
        const Lane most(infinity<Number>);
        for (std::size_t k = 0; k < dimension; ++k) {
            most.store(smallest_q_[k]);
            most.store(smallest_p_[k]);
        }
        Lane(Number(0)).store(stalls_);
    }

    /// Judges one sweep as RoundOff::judge() does. The verdicts of lanes that are not `watched` are
    /// arbitrary.
    template <bool by_q, bool by_p, class Coupled>
    [[nodiscard]] Verdicts judge(const Coupled& coupled, const Mask& watched) {
        const Lane zero(Number(0));
        Seen seen{zero, Mask(false)};
        if constexpr (by_q) { look(coupled.s.change_q, smallest_q_, seen); }
        if constexpr (by_p) { look(coupled.s.change_p, smallest_p_, seen); }
        const Mask finite = seen.total < Lane(infinity<Number>);
        const Mask unchanged = seen.total == zero;
        const Lane stalls = select(seen.falls, zero, Lane(stalls_) + Lane(Number(1)));
        stalls.store(stalls_);
        const Mask stalled = watched & finite & !unchanged & (Lane(Number(2)) <= stalls);
        if (!any(stalled)) { return {unchanged, stalled, !finite}; }
        return {unchanged, stalled & is_noise<by_q, by_p>(coupled), !finite};
    }

private:
    static constexpr Number rounding = 8 * epsilon<Number>;
    static constexpr Number noise = power_of_two<Number>(-(3 * bits<Number> + 3) / 4);
    static constexpr int patience = 10;

    struct Seen {
        Lane total;
        Mask falls;
    };

    static void look(const Changes& change, Changes& smallest, Seen& seen) {
        const Lane zero(Number(0));
        for (std::size_t k = 0; k < dimension; ++k) {
            const Lane now(change[k]);
            const Lane least(smallest[k]);
            const Mask is_smaller = now < least;
            seen.total = seen.total + now;
            seen.falls = seen.falls | (is_smaller & (zero < now));
            select(is_smaller, now, least).store(smallest[k]);
        }
    }

    template <bool by_q, bool by_p, class Coupled>
    [[nodiscard]] Mask is_noise(const Coupled& coupled) const {
        Mask by_component(true);
        Mask by_norm = Lane(Number(patience)) <= Lane(stalls_);
        const auto compare = [&](const Changes& changes, auto size) {
            Lane largest_change(Number(0));
            Lane largest_size(Number(0));
            for (std::size_t k = 0; k < dimension; ++k) {
                const Lane size_k = size(k);
                const Lane change(changes[k]);
                by_component = by_component & (change <= Lane(rounding) * size_k);
                largest_change = larger(largest_change, change);
                largest_size = larger(largest_size, size_k);
            }
            by_norm = by_norm & (largest_change <= Lane(noise) * largest_size);
        };
        if constexpr (by_q) {
            compare(coupled.s.change_q, [&](std::size_t k) { return coupled.s.size_q(k); });
        }
        if constexpr (by_p) {
            compare(coupled.s.change_p, [&](std::size_t k) { return coupled.s.size_p(k); });
        }
        return by_component | by_norm;
    }

    [[nodiscard]] static Lane larger(const Lane& a, const Lane& b) { return select(a < b, b, a); }

    Changes smallest_q_{}, smallest_p_{};  // change of each component so far
    typename Lane::Row
        stalls_{};  // sweeps in a row in which no component changed by less than ever
};

/// Outcome of an iteration in the lanes that took part.
template <class Number>
struct LaneOutcome {
    using Lane = Lanes<Number, trajectories_at_once>;

    typename Lane::Mask converged, not_finite;
    Lane iterations;
};

/// Makes one sweep. NOTE: slopes of lanes that are not `moving` keep their bits.
template <class Coupled, class Mask>
void sweep_lanes(Coupled& coupled, [[maybe_unused]] const Mask& moving) {
    coupled.momenta();
    if constexpr (!HasJointSlopes<Coupled>::value) { coupled.velocities(moving); }
    coupled.positions();
}

/// Sets the slopes of these lanes at the last stages.
template <class Coupled, class Mask>
void close_lanes(Coupled& coupled, const Mask& lanes) {
    if constexpr (HasJointSlopes<Coupled>::value) {
        coupled.slopes(lanes);
    } else {
        coupled.forces(lanes);
    }
}

/// Sweeps of each lane. Where the iteration of a lane has ended, its slopes keep their bits while
/// those of others go on.
template <class Number, std::size_t dimension>
class LaneSweeps {
public:
    using Lane = Lanes<Number, trajectories_at_once>;
    using Mask = typename Lane::Mask;
    using Outcome = LaneOutcome<Number>;

    static constexpr int most_iterations = 200;

    /// Iterates the lanes `going`. NOTE: forces are computed in one place alone; see
    /// Trajectories::end().
    ///
    /// Precondition: the slopes of the lanes `going` hold starting values, those of p in any case.
    template <class Coupled>
    [[nodiscard]] Outcome solve(Coupled coupled, const Mask& going) {
        Outcome outcome{Mask(false), Mask(false), Lane(Number(0))};
        constexpr bool is_joint = HasJointSlopes<Coupled>::value;
        if constexpr (!Coupled::separable && !is_joint) { coupled.positions(); }
        round_off_.begin();
        Mask moving = going;
        Mask closing(false);  // lanes at noise, which take the slopes of the last stages
        sweep_lanes(coupled, moving);
        for (int iteration = 2; any(moving | closing); ++iteration) {
            close_lanes(coupled, moving | closing);
            if (!any(moving) || iteration > most_iterations) { break; }
            sweep_lanes(coupled, moving);
            const auto verdicts = judge(coupled, moving);
            const Mask ended = verdicts.unchanged | verdicts.at_noise;
            outcome.iterations =
                select(moving, Lane(static_cast<Number>(iteration)), outcome.iterations);
            outcome.converged = outcome.converged | (moving & ended);
            // NOTE: a value that is not finite after the first sweeps comes from a diverging
            // iteration.
            if (iteration == 2) { outcome.not_finite = moving & verdicts.not_finite; }
            closing = moving & verdicts.at_noise;
            moving = moving & !(ended | verdicts.not_finite);
        }
        return outcome;
    }

private:
    template <class Coupled>
    [[nodiscard]] auto judge(const Coupled& coupled, const Mask& moving) {
        constexpr bool by_p = Coupled::has_p && !Coupled::separable;
        return round_off_.template judge<true, by_p>(coupled, moving);
    }

    LaneRoundOff<Number, dimension> round_off_;
};

/// CountedSweeps of each lane.
template <class Number, std::size_t dimension, int count>
class CountedLaneSweeps {
public:
    using Lane = Lanes<Number, trajectories_at_once>;
    using Mask = typename Lane::Mask;
    using Outcome = LaneOutcome<Number>;

    /// Makes `count` sweeps of the lanes `going`, and more of those that begin, and a last
    /// evaluation. Precondition: that of LaneSweeps.
    template <class Coupled>
    [[nodiscard]] Outcome solve(Coupled coupled, const Mask& going) {
        constexpr bool is_joint = HasJointSlopes<Coupled>::value;
        if constexpr (!Coupled::separable && !is_joint) { coupled.positions(); }
        const Mask early = begin(coupled.s.new_lanes(), going);
        for (int left = any(early) ? count + more_from_start : count; left > 0; --left) {
            const Mask moving = left > count ? early : going;
            sweep_lanes(coupled, moving);
            close_lanes(coupled, moving);
        }
        Lane size(Number(0));
        for (std::size_t k = 0; k < dimension; ++k) {
            size = size + coupled.s.size_q(k);
            if constexpr (Coupled::has_p) { size = size + coupled.s.size_p(k); }
        }
        const Mask is_finite = size < Lane(infinity<Number>);
        const Lane sweeps = select(early, Lane(static_cast<Number>(count + more_from_start)),
                                   Lane(static_cast<Number>(count)));
        return {going & is_finite, going & !is_finite, select(going, sweeps, Lane(Number(0)))};
    }

private:
    /// Returns the lanes `going` that have no slopes to extrapolate, or had none a step before.
    [[nodiscard]] Mask begin(const Mask& are_new, const Mask& going) {
        const Lane zero(Number(0)), one(Number(1));
        const Mask early = going & (are_new | (Lane(was_new_) == one));
        select(going, select(are_new, one, zero), Lane(was_new_)).store(was_new_);
        return early;
    }

    typename Lane::Row was_new_{};  ///< 1 in lanes that had no slopes a step before
};

}  // namespace hvi::detail
