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
        path.change = x;
        for (auto& number : path.change.q) { number = 0; }
        for (auto& number : path.change.p) { number = 0; }
        return sums_are_exact<Number>();
    }

    /// Adds the changes to x where the sums are finite.
    [[nodiscard]] bool end(State& x, FlowPath<State>& path) {
        add(x.q, path.change.q, path.x.q);
        add(x.p, path.change.p, path.x.p);
        if (!are_finite(path.x.q) || !are_finite(path.x.p)) { return false; }
        x = path.x;
        at_ = path.x;
        remainder_ = path.change;
        ended_ = true;
        return true;
    }

    void forget() { ended_ = false; }

private:
    /// Sets `sum` to from + change, and `change` to the remainder of the sum.
    template <class Numbers>
    static constexpr void add(const Numbers& from, Numbers& change, Numbers& sum) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(from.size()); ++k) {
            const auto exact = two_sum(from[k], change[k]);
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
