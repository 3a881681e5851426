// Sums of the changes in a step that is made of flows.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_FLOW_SUMS_HPP
#define HVI_FLOW_SUMS_HPP

#include <cstddef>
#include <type_traits>
#include <utility>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// A state on its way through a step, and the sum of its changes so far.
template <class State>
struct FlowPath {
    State x, change;

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
    State cut_off;  ///< from the sum of the changes

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
        path.x = x;
        const bool continues = ended_ && same_bits(at_.q, x.q) && same_bits(at_.p, x.p);
        if (continues) {
            path.change = remainder_;
            return true;
        }
        path.change = zero(x);
        return sums_are_exact<Number>();
    }
    [[nodiscard]] bool begin(const State& x, LongFlowPath<State>& path) const {
        path.cut_off = zero(x);
        return begin(x, static_cast<FlowPath<State>&>(path));
    }

    /// Adds the changes to x where the sums are finite.
    [[nodiscard]] bool end(State& x, FlowPath<State>& path) {
        add(x.q, path.change.q, path.x.q);
        add(x.p, path.change.p, path.x.p);
        return ends(x, path);
    }
    [[nodiscard]] bool end(State& x, LongFlowPath<State>& path) {
        add(x.q, path.change.q, path.x.q, path.cut_off.q);
        add(x.p, path.change.p, path.x.p, path.cut_off.p);
        return ends(x, path);
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

    /// Keeps the end of a step and its remainder where they are finite.
    [[nodiscard]] bool ends(State& x, const FlowPath<State>& path) {
        if (!are_finite(path.x.q) || !are_finite(path.x.p)) { return false; }
        x = path.x;
        at_ = path.x;
        remainder_ = path.change;
        ended_ = true;
        return true;
    }

    /// Sets `sum` to from + change, and `change` to the remainder of the sum.
    template <class Numbers>
    static constexpr void add(const Numbers& from, Numbers& change, Numbers& sum) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(from.size()); ++k) {
            const auto exact = two_sum(from[k], change[k]);
            sum[k] = exact.value;
            change[k] = exact.remainder;
        }
    }

    /// The same with what was cut off from the change.
    template <class Numbers>
    static constexpr void add(const Numbers& from, Numbers& change, Numbers& sum,
                              const Numbers& cut_off) {
        add(from, change, sum);
        for (std::size_t k = 0; k < static_cast<std::size_t>(from.size()); ++k) {
            const auto exact = two_sum<Number>(sum[k], change[k] + cut_off[k]);
            sum[k] = exact.value;
            change[k] = exact.remainder;
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
