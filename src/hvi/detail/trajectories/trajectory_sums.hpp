// The sums of steps of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi::detail {

/// Sums of steps of trajectories: one exact sum a step, as in StepSums; remainders are part of the
/// state.
template <class State>
class TrajectorySums {
public:
    using Scalar = typename State::Scalar;
    using Values = typename State::Values;
    using PositionValues = typename State::PositionValues;

    /// Begins a step of these sizes from x. Returns whether it has something to do. Where sums do
    /// not round as they should, all lanes stop.
    [[nodiscard]] bool begin(State& x, const typename State::Lane::Row& h) {
        if (!are_exact_) { are_exact_ = sums_are_exact<Scalar>(); }
        if (!are_exact_) { x.stop(Mask(true), Status::Code::unsafe_arithmetic); }
        return x.begins(h);
    }

    /// Ends the step: adds these changes, which include the remainders so far, to q and p. `carry`
    /// moves the memory of x, as in Trajectories::end().
    template <class Carry>
    static void end(State& x, PositionValues& change_q, Values& change_p, Carry carry) {
        PositionValues q;
        Values p;
        add(x.q, change_q, q);
        add(x.p, change_p, p);
        end_at(x, q, p, change_q, change_p, carry);
    }

    /// Ends the step at q and p with these remainders.
    template <class Carry>
    static void end_at(State& x, const PositionValues& q, const Values& p,
                       const PositionValues& remainder_q, const Values& remainder_p, Carry carry) {
        x.end(q, p, where_finite(q, p), [&](auto put) {
            put(remainder_q, x.carried.q);
            put(remainder_p, x.carried.p);
            carry(put);
        });
    }

    /// Ends a step that leaves no memory beside the remainders.
    static void end(State& x, PositionValues& change_q, Values& change_p) {
        end(x, change_q, change_p, [](auto) {});
    }

    void forget() { are_exact_ = false; }

private:
    using Lane = typename State::Lane;
    using Mask = typename State::Mask;

    /// Sets `sum` to from + change, and `change` to the remainder of the sum.
    template <std::size_t dimension>
    static void add(const std::array<typename Lane::Row, dimension>& from,
                    std::array<Lane, dimension>& change, std::array<Lane, dimension>& sum) {
        for (std::size_t k = 0; k < from.size(); ++k) {
            const Sum<Lane> exact = two_sum<Lane>(from[k], change[k]);
            sum[k] = exact.value;
            change[k] = exact.remainder;
        }
    }

    bool are_exact_ = false;  ///< whether sums are known to be exact, since reset()
};

}  // namespace hvi::detail
