// States at given times.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include <hvi/detail/trajectories/event_steps.hpp>
#include <hvi/integrate.hpp>

namespace hvi {

/// Takes steps of size h from x at the time `start` until all `times` are passed, and calls
/// observe(y, t) at each of the times. y is the state there, reached by a shorter step from the
/// beginning of the step that contains the time. The steps have the same bits as those of
/// integrate().
/// # Use
/// `times` ascend where h is positive, and descend where h is negative. Times before the start are
/// left out. x becomes the state at the end of the last step.
/// ```cpp
/// #include <array>
/// #include <cmath>
///
/// #include <hvi/integrate_at.hpp>
/// #include <hvi/generated/gauss_4.hpp>
///
/// struct Spring {  // H = (p^2 + q^2)/2
///     using Vector = std::array<double, 1>;
///     void dHdq(const Vector& q, const Vector&, Vector& out) const { out = q; }
///     void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
/// };
///
/// int main() {
///     hvi::generated::Gauss4<Spring> stepper;
///     hvi::State<Spring::Vector> x{{1.0}, {0.0}};
///     double error = 0;
///     const auto observe = [&](const auto& y, double t) {
///         error = std::fmax(error, std::abs(y.q[0] - std::cos(t)));
///     };
///     const auto run = hvi::integrate_at(stepper, x, 0.0, 0.1, {0.25, 1.0, 3.1415926}, observe);
///     return run.ok() && run.steps == 32 && error < 1e-12 ? 0 : 1;
/// }
/// ```
template <class Stepper, class Observer>
Run integrate_at(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar start,
                 typename Stepper::Scalar h, const std::vector<typename Stepper::Scalar>& times,
                 Observer&& observe) {
    using Scalar = typename Stepper::Scalar;
    detail::EventSteps<Stepper> all({}, stepper);
    all.output_at(times, std::forward<Observer>(observe));
    EventRun<Scalar> result;
    all.begin(x, start, h);
    while (all.has_output() && result.ending == Ending::all_steps && h != 0) {
        const Scalar next = start + static_cast<Scalar>(result.run.steps + 1) * h;
        all.take(stepper, x, h, next, result);
    }
    return result.run;
}

}  // namespace hvi
