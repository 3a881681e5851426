// Many steps in a row.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <hvi/detail/run.hpp>
#include <hvi/detail/trajectories/take.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// Takes steps of size h from x at the time `start`, and calls observe(x, t) before the first step
/// and after each. A step that fails ends the run, and x is then the state after the last good
/// step. The times are start + k h, each rounded by itself, so that they do not drift.
/// # Use
/// `stepper` is of a class that hvi-gen has written. h is a time in the units of H and may be
/// negative. No step is taken where `steps` is not positive. observe(x, t) gets a const
/// Stepper::State& and a Stepper::Scalar, and its exceptions leave integrate(). NOTE: `start` is
/// for the observer alone; where H depends on the time, a step begins at the time x.t.
/// ```cpp
/// #include <array>
/// #include <cmath>
/// #include <cstdio>
///
/// #include <hvi/generated/gauss_4.hpp>
/// #include <hvi/integrate.hpp>
///
/// struct Planet {  // H = |p|^2/2 - 1/|q|
///     using Vector = std::array<double, 2>;
///     void dHdq(const Vector& q, const Vector&, Vector& out) const {
///         const double r = std::hypot(q[0], q[1]);
///         out = {q[0] / (r * r * r), q[1] / (r * r * r)};
///     }
///     void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
/// };
///
/// int main() {
///     // Nearest to the sun on an ellipse of semi-axis 1 and eccentricity 1/2.
///     hvi::State<Planet::Vector> x{{0.5, 0.0}, {0.0, std::sqrt(3.0)}};
///     hvi::generated::Gauss4<Planet> stepper;
///     const double year = 2 * std::acos(-1.0);
///     double farthest = 0;
///     double when = 0;
///     const auto observe = [&](const auto& y, double t) {
///         const double r = std::hypot(y.q[0], y.q[1]);
///         if (r > farthest) {
///             farthest = r;
///             when = t;
///         }
///     };
///     const hvi::Run run = hvi::integrate(stepper, x, 0.0, year / 200, 200, observe);
///     if (!run.ok()) {
///         std::puts(run.status.message());
///         return 1;
///     }
///     // Kepler: it is 3/2 from the sun after half a year, and back after a year.
///     const bool is_far = std::abs(farthest - 1.5) < 1e-11 && std::abs(when - year / 2) < 1e-11;
///     return is_far && std::hypot(x.q[0] - 0.5, x.q[1]) < 1e-11 ? 0 : 1;
/// }
/// ```
template <class Stepper, class Observer>
Run integrate(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar start,
              typename Stepper::Scalar h, std::int64_t steps, Observer&& observe) {
    using Scalar = typename Stepper::Scalar;
    const auto& unchanged = x;
    Run run;
    observe(unchanged, start);
    while (run.steps < steps) {
        run.status = stepper.step(x, h);
        run.iterations += run.status.iterations;
        if (!run.ok()) { return run; }
        ++run.steps;
        observe(unchanged, start + static_cast<Scalar>(run.steps) * h);
    }
    return run;
}

/// Takes steps without an observer, by advance() of the stepper where it has one: splittings then
/// join the flows at the ends of steps, and differ from single steps in round-off.
template <class Stepper>
Run integrate(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar,
              typename Stepper::Scalar h, std::int64_t steps) {
    return detail::take(stepper, x, h, steps);
}

}  // namespace hvi
