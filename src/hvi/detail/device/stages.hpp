// The stages of implicit steps of one trajectory on a device, and their iteration by fixed points.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/device/steps.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::device {

template <class Number>
[[nodiscard]] HVI_DEVICE constexpr Real<Number> size_of(Real<Number> x) {
    return x < Real<Number>(0) ? -x : x;
}

/// A square table, as member of an argument of a kernel.
template <class Number, std::size_t s>
struct Table {
    Number rows[s][s];
};

/// Returns the table of the same entries.
template <class Number, std::size_t s>
[[nodiscard]] Table<Number, s> table_of(const Number (&entries)[s][s]) {
    Table<Number, s> result{};
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) { result.rows[i][j] = entries[i][j]; }
    }
    return result;
}

/// Stage values Q_i, P_i and their slopes Lq_i, Lp_i, in scaled form; see detail::Stages. Sums and
/// the order of sums are those of detail::PairTrajectories.
template <class Number, std::size_t n, std::size_t s>
class Stages {
public:
    using Scalar = Real<Number>;
    using Values = Vector<Scalar, n>;

    Values q, p, remainder_q, remainder_p;  ///< start of the step
    Values Q[s]{}, P[s]{}, Lq[s]{}, Lp[s]{};
    Values change_q{}, change_p{};  ///< of the stage values in one sweep, over stages

    template <class State>
    HVI_DEVICE explicit Stages(const State& x)
        : q(load(x.q)),
          p(load(x.p)),
          remainder_q(load(x.remainder_q)),
          remainder_p(load(x.remainder_p)) {}

    /// Sets a slope to factor * gradient.
    HVI_DEVICE static void set(Values& slope, Scalar factor, const Values& gradient) {
        for (std::size_t k = 0; k < n; ++k) { slope[k] = factor * gradient[k]; }
    }

    /// Sets slopes to N times those of the step before.
    HVI_DEVICE static void extrapolate(const Table<Number, s>& N,
                                       const Vector<Number, n> (&last)[s], Values (&slopes)[s]) {
        Values before[s];
        for (std::size_t i = 0; i < s; ++i) { before[i] = load(last[i]); }
        for (std::size_t i = 0; i < s; ++i) {
            for (std::size_t k = 0; k < n; ++k) {
                slopes[i][k] = sum(N.rows[i], before, k, Scalar(0));
            }
        }
    }

    /// Sets Q_i = q + (e_q + sum_j m_ij Lq_j).
    HVI_DEVICE void positions(const Table<Number, s>& m) {
        stage_values(m, Lq, q, remainder_q, Q, change_q);
    }

    /// Sets P_j = p + (e_p + sum_i mt_ji Lp_i).
    HVI_DEVICE void momenta(const Table<Number, s>& mt) {
        stage_values(mt, Lp, p, remainder_p, P, change_p);
    }

    /// Moves q and p to the end of the step, and the remainders with them.
    HVI_DEVICE void advance() {
        for (std::size_t k = 0; k < n; ++k) {
            Scalar sum_q = Lq[0][k];
            Scalar sum_p = Lp[0][k];
            for (std::size_t j = 1; j < s; ++j) {
                sum_q += Lq[j][k];
                sum_p += Lp[j][k];
            }
            move(q[k], remainder_q[k], sum_q);
            move(p[k], remainder_p[k], sum_p);
        }
    }

    /// Return the size that the rounding of component k of Q, and of P, is compared with.
    [[nodiscard]] HVI_DEVICE Scalar size_q(std::size_t k) const { return size(q, Q, Lq, k); }
    [[nodiscard]] HVI_DEVICE Scalar size_p(std::size_t k) const { return size(p, P, Lp, k); }

private:
    /// Returns start + sum_j row_j x_j, in two sums.
    [[nodiscard]] HVI_DEVICE static Scalar sum(const Number (&row)[s], const Values (&x)[s],
                                               std::size_t k, Scalar start) {
        start += row[0] * x[0][k];
        if constexpr (s > 1) {
            Scalar other = row[1] * x[1][k];
            for (std::size_t j = 2; j + 1 < s; j += 2) {
                start += row[j] * x[j][k];
                other += row[j + 1] * x[j + 1][k];
            }
            if constexpr (s % 2 == 1) { start += row[s - 1] * x[s - 1][k]; }
            start += other;
        }
        return start;
    }

    HVI_DEVICE static void stage_values(const Table<Number, s>& m, const Values (&slopes)[s],
                                        const Values& start, const Values& cut_off,
                                        Values (&values)[s], Values& changes) {
        for (std::size_t k = 0; k < n; ++k) {
            Scalar change = 0;
            for (std::size_t i = 0; i < s; ++i) {
                const Scalar value = start[k] + sum(m.rows[i], slopes, k, cut_off[k]);
                change += size_of(value - values[i][k]);
                values[i][k] = value;
            }
            changes[k] = change;
        }
    }

    HVI_DEVICE static void move(Scalar& point, Scalar& remainder, Scalar increment) {
        const Sum<Number> exact = two_sum<Number>(point, remainder + increment);
        point = exact.value;
        remainder = exact.remainder;
    }

    [[nodiscard]] HVI_DEVICE static Scalar size(const Values& start, const Values (&values)[s],
                                                const Values (&slopes)[s], std::size_t k) {
        Scalar size = size_of(start[k]);
        for (std::size_t i = 0; i < s; ++i) {
            size += size_of(values[i][k]) + size_of(slopes[i][k]);
        }
        return size;
    }
};

/// Watches the changes of an iteration and ends it at round-off; see detail::RoundOff.
template <class Number, std::size_t n>
class RoundOff {
public:
    using Scalar = Real<Number>;
    using Values = Vector<Scalar, n>;

    enum class Verdict { go_on, unchanged, at_noise, not_finite };

    HVI_DEVICE RoundOff() {
        for (std::size_t k = 0; k < n; ++k) { smallest_q_[k] = smallest_p_[k] = most; }
    }

    /// Judges one sweep, by its changes of P only where `by_p`.
    template <bool by_p, class Stages>
    [[nodiscard]] HVI_DEVICE Verdict judge(const Stages& s) {
        Scalar total = 0;
        bool falls = look(s.change_q, smallest_q_, total);
        if constexpr (by_p) { falls = look(s.change_p, smallest_p_, total) || falls; }
        if (!(total < Scalar(most))) { return Verdict::not_finite; }
        if (total == Scalar(0)) { return Verdict::unchanged; }
        stalls_ = falls ? 0 : stalls_ + 1;
        return stalls_ >= 2 && is_noise<by_p>(s) ? Verdict::at_noise : Verdict::go_on;
    }

private:
    static constexpr Number most = detail::infinity<Number>;
    static constexpr Number rounding = 8 * detail::epsilon<Number>;
    static constexpr Number noise =
        detail::power_of_two<Number>(-(3 * detail::bits<Number> + 3) / 4);
    static constexpr int patience = 10;

    [[nodiscard]] HVI_DEVICE static bool look(const Values& change, Values& smallest,
                                              Scalar& total) {
        bool falls = false;
        for (std::size_t k = 0; k < n; ++k) {
            const bool is_smaller = change[k] < smallest[k];
            total += change[k];
            falls = falls || (is_smaller && Scalar(0) < change[k]);
            if (is_smaller) { smallest[k] = change[k]; }
        }
        return falls;
    }

    template <bool by_p, class Stages>
    [[nodiscard]] HVI_DEVICE bool is_noise(const Stages& s) const {
        bool by_component = true, by_norm = stalls_ >= patience;
        const auto compare = [&](const Values& changes, auto size) {
            Scalar largest_change = 0, largest_size = 0;
            for (std::size_t k = 0; k < n; ++k) {
                const Scalar size_k = size(k);
                by_component = by_component && changes[k] <= Scalar(rounding) * size_k;
                if (largest_change < changes[k]) { largest_change = changes[k]; }
                if (largest_size < size_k) { largest_size = size_k; }
            }
            by_norm = by_norm && largest_change <= Scalar(noise) * largest_size;
        };
        compare(s.change_q, [&](std::size_t k) { return s.size_q(k); });
        if constexpr (by_p) {
            compare(s.change_p, [&](std::size_t k) { return s.size_p(k); });
        }
        return by_component || by_norm;
    }

    Values smallest_q_{}, smallest_p_{};  ///< change of each component so far
    int stalls_ = 0;  ///< sweeps in a row in which no component changed by less than ever
};

inline constexpr int most_sweeps = 200;

/// Iterates partitioned sweeps to round-off, and returns how that ended; `sweeps` counts them. See
/// detail::LaneSweeps. Precondition: the slopes hold starting values, those of p in any case.
template <class Coupled>
[[nodiscard]] HVI_DEVICE Status::Code solve(Coupled& coupled, int& sweeps) {
    using Watch = typename Coupled::Watch;
    using Verdict = typename Watch::Verdict;
    if constexpr (!Coupled::separable && !Coupled::joint) { coupled.positions(); }
    Watch round_off;
    coupled.sweep();  // this change is measured against values of no meaning
    for (sweeps = 2; sweeps <= most_sweeps; ++sweeps) {
        coupled.evaluate();
        coupled.sweep();
        switch (round_off.template judge<!Coupled::separable>(coupled.s)) {
        case Verdict::go_on: break;
        case Verdict::unchanged: return Status::Code::ok;
        case Verdict::at_noise: coupled.evaluate(); return Status::Code::ok;
        case Verdict::not_finite:
            // NOTE: a value that is not finite after the first sweeps comes from a diverging
            // iteration.
            return sweeps == 2 ? Status::Code::not_finite : Status::Code::not_converged;
        }
    }
    sweeps = most_sweeps;
    return Status::Code::not_converged;
}

}  // namespace hvi::device
