// The time of Hamiltonians that depend on it.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_CLOCK_HPP
#define HVI_CLOCK_HPP

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// Positions, momenta and the time.
template <class Vector>
struct TimedState : State<Vector> {
    detail::ScalarOf<Vector> t = 0;
};

namespace detail {

/// Times T_i = t + c_i h of the stages. The time is a coordinate of the extended system. Its
/// velocity is 1, and its momentum is not needed: (4.18c) gives T_i. The time is summed up with
/// compensation, and its remainder belongs to the time at which the last step ended.
template <class Scalar>
class StepClock {
public:
    Scalar start = 0;  ///< of the step

    /// Begins a step. Returns false where the last one did not end at this time.
    [[nodiscard]] bool begin(Scalar now, Scalar h) {
        const bool continues = ended_ && now == end_;
        if (!continues) { remainder_ = 0; }
        ended_ = false;
        start = now;
        h_ = h;
        return continues;
    }

    /// Returns T_i of a stage with this c_i.
    [[nodiscard]] Scalar at(Scalar c) const { return after(c * h_); }

    /// Returns the time at this distance from the start.
    [[nodiscard]] Scalar after(Scalar distance) const { return start + (remainder_ + distance); }

    /// Returns whether the step ends at a finite time. NOTE: asked before the step, since its state
    /// has moved when end() is called.
    [[nodiscard]] bool ends() const { return is_finite(start + (remainder_ + h_)); }

    /// Moves the time on where the step went well.
    [[nodiscard]] Status end(Scalar& now, Status status) {
        if (!status.ok()) { return status; }
        const Sum<Scalar> sum = two_sum(start, remainder_ + h_);
        if (!is_finite(sum.value)) { return Status(Status::Code::not_finite, status.iterations); }
        now = end_ = sum.value;
        remainder_ = sum.remainder;
        ended_ = true;
        return status;
    }

private:
    Scalar end_ = 0;
    Scalar remainder_ = 0;  // remainder of end_
    Scalar h_ = 0;
    bool ended_ = false;
};

/// The clock of a step with the times of all its stages.
template <class Scalar, std::size_t stages>
class Clock : public StepClock<Scalar> {
public:
    std::array<Scalar, stages> t{};

    [[nodiscard]] bool begin(Scalar now, Scalar h, const Scalar (&c)[stages]) {
        const bool continues = StepClock<Scalar>::begin(now, h);
        for (std::size_t i = 0; i < stages; ++i) { t[i] = this->at(c[i]); }
        return continues;
    }
};

/// The clock of a step that is made of flows. The time goes on with the flows of one part of H, and
/// stands still in those of the others.
template <class Scalar>
class FlowClock : public StepClock<Scalar> {
public:
    [[nodiscard]] bool begin(Scalar now, Scalar h) {
        gone_ = 0;
        return StepClock<Scalar>::begin(now, h);
    }

    void go_on(Scalar by) { gone_ += by; }

    [[nodiscard]] Scalar now() const { return this->after(gone_); }

    /// Ends a step of size h and begins the next one in a row, on which the time may have gone on
    /// already. Returns false where the time is not finite.
    [[nodiscard]] bool pass(Scalar& time, Scalar h) {
        const Scalar gone = gone_ - h;
        if (!this->end(time, Status{}).ok() || !begin(time, h)) { return false; }
        gone_ = gone;
        return this->ends();
    }

private:
    Scalar gone_ = 0;
};

/// A path whose time goes on; see FlowPath.
template <class Path, class Scalar>
struct TimedPath : Path {
    FlowClock<Scalar>& clock;

    explicit TimedPath(FlowClock<Scalar>& of) : clock(of) {}

    void move_t(Scalar by) { clock.go_on(by); }
};

}  // namespace detail
}  // namespace hvi

#endif  // HVI_CLOCK_HPP
