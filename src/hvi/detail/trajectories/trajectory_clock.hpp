// The times of trajectories side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/clock.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi {

/// Number of trajectories that go side by side, on any processor, so that results depend on it in
/// one way only: whether it fuses products and sums. They fill one register of AVX-512, two of
/// AVX2, four of SSE2 or NEON.
inline constexpr std::size_t trajectories_at_once = 8;

namespace detail {

/// Empty clock: H does not depend on time.
template <class Trajectory>
class TrajectoryClock {
public:
    struct End {
        template <class Mask>
        [[nodiscard]] const Mask& finite(const Mask& made) const {
            return made;
        }

        template <class Put>
        void move(TrajectoryClock&, const Put&) const {}
    };

    void set(std::size_t, const Trajectory&) {}
    void get(std::size_t, Trajectory&) const {}
    void take(std::size_t, const TrajectoryClock&, std::size_t) {}

    template <class Row>
    void begin(const Row&) {}

    [[nodiscard]] End end() const { return {}; }
    [[nodiscard]] bool shows_time_of(const TrajectoryClock&) const { return true; }
    [[nodiscard]] bool shows_time_of(const TrajectoryClock&, std::size_t) const { return true; }
};

/// Times of the lanes, summed up as Clock does; remainders are part of the state.
template <class Vector>
class TrajectoryClock<TimedState<Vector>> {
public:
    using Scalar = ScalarOf<Vector>;
    using Lane = Lanes<Scalar, trajectories_at_once>;
    using Mask = typename Lane::Mask;

    /// End of a step.
    ///
    /// NOTE: computed once, as all values that masks choose between; see Trajectories::end().
    struct End {
        Sum<Lane> time;

        [[nodiscard]] Mask finite(const Mask& made) const {
            return made & (time.value - time.value == Lane(Scalar(0)));
        }

        template <class Put>
        void move(TrajectoryClock& clock, const Put& put) const {
            put(time.value, clock.t_);
            put(time.remainder, clock.remainder_);
        }
    };

    void set(std::size_t lane, const TimedState<Vector>& x) {
        t_.set(lane, x.t);
        remainder_.set(lane, 0);
    }

    void get(std::size_t lane, TimedState<Vector>& x) const { x.t = t_[lane]; }

    void take(std::size_t lane, const TrajectoryClock& other, std::size_t from) {
        t_.set(lane, other.t_[from]);
        remainder_.set(lane, other.remainder_[from]);
    }

    /// Begins a step of these sizes.
    void begin(const typename Lane::Row& h) { h_ = h; }

    /// Returns the time of the state.
    [[nodiscard]] Lane start() const { return t_; }

    /// Returns T_i = t + c_i h.
    [[nodiscard]] Lane at(Scalar c) const { return start() + (Lane(remainder_) + c * Lane(h_)); }

    [[nodiscard]] End end() const { return {two_sum<Lane>(t_, Lane(remainder_) + Lane(h_))}; }

    [[nodiscard]] bool shows_time_of(const TrajectoryClock& other) const {
        return same_bits(t_, other.t_);
    }
    [[nodiscard]] bool shows_time_of(const TrajectoryClock& other, std::size_t lane) const {
        typename Lane::Row same = t_;
        same.set(lane, other.t_[lane]);
        return same_bits(t_, same);
    }

private:
    typename Lane::Row t_{}, remainder_{}, h_{};
};

}  // namespace detail
}  // namespace hvi
