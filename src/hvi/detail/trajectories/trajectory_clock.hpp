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

    template <class Scalar>
    void begin(const Scalar&) {}

    [[nodiscard]] End end() const { return {}; }
    [[nodiscard]] bool shows_time_of(const TrajectoryClock&) const { return true; }
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

    /// Begins a step of size h.
    void begin(Scalar h) { h_ = h; }

    /// Returns the time of the state.
    [[nodiscard]] Lane start() const { return t_; }

    /// Returns T_i = t + c_i h.
    [[nodiscard]] Lane at(Scalar c) const { return start() + (Lane(remainder_) + Lane(c * h_)); }

    [[nodiscard]] End end() const { return {two_sum<Lane>(t_, Lane(remainder_) + Lane(h_))}; }

    [[nodiscard]] bool shows_time_of(const TrajectoryClock& other) const {
        return same_bits(t_, other.t_);
    }

private:
    typename Lane::Row t_{}, remainder_{};
    Scalar h_ = 0;
};

}  // namespace detail
}  // namespace hvi
