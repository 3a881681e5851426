// Sums of the changes in a step that is made of flows.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_FLOW_SUMS_HPP
#define HVI_FLOW_SUMS_HPP

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
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
    [[nodiscard]] bool begin(const State& x, FlowPath<State>& path) const {
        path.x.take(x);
        const bool continues = ended_ && same_bits(at_.q, x.q) && same_bits(at_.p, x.p);
        if (continues) {
            path.change.take(remainder_);
            return true;
        }
        path.change.take(zero(x));
        return sums_are_exact<Number>();
    }
    [[nodiscard]] bool begin(const State& x, LongFlowPath<State>& path) const {
        path.cut_off.take(zero(x));
        return begin(x, static_cast<FlowPath<State>&>(path));
    }

    /// Adds the changes to x where the sums are finite.
    [[nodiscard]] bool end(State& x, const FlowPath<State>& path) {
        State sum = x, remainder = x;
        add(x.q, path.change.q, sum.q, remainder.q);
        add(x.p, path.change.p, sum.p, remainder.p);
        return ends(x, sum, remainder);
    }
    [[nodiscard]] bool end(State& x, const LongFlowPath<State>& path) {
        State sum = x, remainder = x;
        add(x.q, path.change.q, sum.q, remainder.q);
        add(x.p, path.change.p, sum.p, remainder.p);
        add_what_was_cut_off(sum.q, remainder.q, path.cut_off.q);
        add_what_was_cut_off(sum.p, remainder.p, path.cut_off.p);
        return ends(x, sum, remainder);
    }

    void forget() { ended_ = false; }

private:
    /// Returns a state of the size of x.
    [[nodiscard]] static State zero(const State& x) {
        State result = x;
        for (auto& number : result.q) { number = 0; }
        for (auto& number : result.p) { number = 0; }
        return result;
    }

    /// Keeps the end of a step and its remainder where the end is finite.
    [[nodiscard]] bool ends(State& x, const State& sum, const State& remainder) {
        if (!are_finite(sum.q) || !are_finite(sum.p)) { return false; }
        x = sum;
        at_ = sum;
        remainder_ = remainder;
        ended_ = true;
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

}  // namespace hvi::detail

#endif  // HVI_FLOW_SUMS_HPP
