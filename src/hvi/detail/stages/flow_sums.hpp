// Sums of the changes in a step that is made of flows.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_FLOW_SUMS_HPP
#define HVI_FLOW_SUMS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/run.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// Numbers of a vector, each beside an empty place.
///
/// NOTE: flows move pairs of numbers, others each time. Of pairs that are neighbours compilers make
/// vectors, and a vector whose numbers were stored one by one is not loaded before they are in the
/// cache: turns of a body then take a fifth longer.
template <class Vector>
class SpacedNumbers {
public:
    using Number = ScalarOf<Vector>;

    void take(const Vector& from) {
        if constexpr (fixed_size<Vector>() == 0) { numbers_.resize(2 * from.size()); }
        for (std::size_t k = 0; k < static_cast<std::size_t>(from.size()); ++k) {
            (*this)[k] = from[k];
        }
    }
    [[nodiscard]] constexpr Number& operator[](std::size_t k) { return numbers_[2 * k]; }
    [[nodiscard]] constexpr const Number& operator[](std::size_t k) const {
        return numbers_[2 * k];
    }

private:
    std::conditional_t<fixed_size<Vector>() == 0, std::vector<Number>,
                       std::array<Number, 2 * fixed_size<Vector>()>>
        numbers_;
};

/// Returns a state of the size of x whose numbers are 0.
template <class State>
[[nodiscard]] State zero_like(const State& x) {
    State result = x;
    for (auto& number : result.q) { number = 0; }
    for (auto& number : result.p) { number = 0; }
    return result;
}

/// A state on its way through a step, and the sum of its changes so far.
template <class State>
struct FlowPath {
    struct Numbers {
        SpacedNumbers<decltype(State::q)> q;
        SpacedNumbers<decltype(State::p)> p;

        void take(const State& from) {
            q.take(from.q);
            p.take(from.p);
        }
    };
    Numbers x, change;

    /// Begins a step from a state with what the step before it left of its changes.
    void begin(const State& at, const State& remainder) {
        x.take(at);
        change.take(remainder);
    }

    template <class Scalar>
    constexpr void move_q(std::size_t k, Scalar by) {
        x.q[k] += by;
        change.q[k] += by;
    }
    template <class Scalar>
    constexpr void move_p(std::size_t k, Scalar by) {
        x.p[k] += by;
        change.p[k] += by;
    }
};

/// A path on which sums keep what rounding cuts off, for changes that have more digits than one
/// number.
template <class State>
struct LongFlowPath : FlowPath<State> {
    typename FlowPath<State>::Numbers cut_off;  ///< from the sum of the changes

    void begin(const State& at, const State& remainder) {
        FlowPath<State>::begin(at, remainder);
        cut_off.take(zero_like(at));
    }

    template <class Scalar>
    constexpr void move_q(std::size_t k, Scalar by, Scalar remainder = 0) {
        move(this->x.q[k], this->change.q[k], cut_off.q[k], by, remainder);
    }
    template <class Scalar>
    constexpr void move_p(std::size_t k, Scalar by, Scalar remainder = 0) {
        move(this->x.p[k], this->change.p[k], cut_off.p[k], by, remainder);
    }

private:
    template <class Number, class Scalar>
    static constexpr void move(Number& at, Number& change, Number& cut_off, Scalar by,
                               Scalar remainder) {
        at += by;
        const auto sum = two_sum<Scalar>(change, by);
        change = sum.value;
        cut_off += sum.remainder + remainder;
    }
};

/// The end of the last step, and its remainder. The changes of a step are summed apart, beginning
/// with the remainder, and the state takes one exact sum a step. Numbers of q and p may differ in
/// count, as for bodies.
///
/// NOTE: only end() changes them, so that a step that failed can be tried again.
template <class State>
class FlowSums {
public:
    /// Begins a step from x: the change is the remainder where x is, bit for bit, the end of the
    /// last step, else 0. Returns false where sums do not round as they should.
    template <class Path>
    [[nodiscard]] bool begin(const State& x, Path& path) const {
        const bool continues = ended_ && same_bits(at_.q, x.q) && same_bits(at_.p, x.p);
        if (continues) {
            path.begin(x, remainder_);
            return true;
        }
        path.begin(x, zero_like(x));
        return sums_are_exact<Number>();
    }

    /// Adds the changes to x where the sums are finite, and goes on from there to the next step in
    /// a row: the change is then the remainder.
    template <class Path>
    [[nodiscard]] static bool pass(State& x, Path& path) {
        State remainder = x;
        if (!add(x, path, remainder)) { return false; }
        path.begin(x, remainder);
        return true;
    }

    /// Adds the changes to x where the sums are finite, and keeps x and its remainder.
    template <class Path>
    [[nodiscard]] bool end(State& x, const Path& path) {
        State remainder = x;
        if (!add(x, path, remainder)) { return false; }
        at_ = x;
        remainder_ = remainder;
        ended_ = true;
        return true;
    }

    void forget() { ended_ = false; }

private:
    /// Adds the changes to x where the sums are finite, and sets the remainder.
    [[nodiscard]] static bool add(State& x, const FlowPath<State>& path, State& remainder) {
        State sum = x;
        add(x.q, path.change.q, sum.q, remainder.q);
        add(x.p, path.change.p, sum.p, remainder.p);
        return set_if_finite(x, sum);
    }
    [[nodiscard]] static bool add(State& x, const LongFlowPath<State>& path, State& remainder) {
        State sum = x;
        add(x.q, path.change.q, sum.q, remainder.q);
        add(x.p, path.change.p, sum.p, remainder.p);
        add_what_was_cut_off(sum.q, remainder.q, path.cut_off.q);
        add_what_was_cut_off(sum.p, remainder.p, path.cut_off.p);
        return set_if_finite(x, sum);
    }

    /// Sets x to the sum where that is finite.
    [[nodiscard]] static bool set_if_finite(State& x, const State& sum) {
        if (!are_finite(sum.q) || !are_finite(sum.p)) { return false; }
        x = sum;
        return true;
    }

    /// Sets `sum` to from + change, and `remainder` to what rounding cuts off.
    template <class Numbers>
    static constexpr void add(const Numbers& from, const SpacedNumbers<Numbers>& change,
                              Numbers& sum, Numbers& remainder) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(from.size()); ++k) {
            const auto exact = two_sum(from[k], change[k]);
            sum[k] = exact.value;
            remainder[k] = exact.remainder;
        }
    }

    template <class Numbers>
    static constexpr void add_what_was_cut_off(Numbers& sum, Numbers& remainder,
                                               const SpacedNumbers<Numbers>& cut_off) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(sum.size()); ++k) {
            const auto exact = two_sum<Number>(sum[k], remainder[k] + cut_off[k]);
            sum[k] = exact.value;
            remainder[k] = exact.remainder;
        }
    }

    template <class Numbers>
    [[nodiscard]] static constexpr bool are_finite(const Numbers& numbers) {
        bool all = true;
        for (const auto& number : numbers) { all = all && is_finite(number); }
        return all;
    }

    using Number = std::decay_t<decltype(std::declval<State&>().q[0])>;

    State at_{};
    State remainder_{};
    bool ended_ = false;
};

/// Takes steps in a row from x by take(count). Where one of them fails they are taken again one by
/// one: x is then the state after the last good step.
template <class State, class Take>
Run take_in_a_row(State& x, std::int64_t steps, Take&& take) {
    Run run;
    if (steps > 1) {
        const State start = x;
        run.status = take(steps);
        if (run.ok()) {
            run.steps = steps;
            return run;
        }
        x = start;
    }
    while (run.steps < steps) {
        run.status = take(std::int64_t(1));
        if (!run.ok()) { break; }
        ++run.steps;
    }
    return run;
}

}  // namespace hvi::detail

#endif  // HVI_FLOW_SUMS_HPP
