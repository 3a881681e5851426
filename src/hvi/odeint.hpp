// Generated steppers in Boost.Odeint.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <utility>

#include <boost/numeric/odeint/stepper/stepper_categories.hpp>

#include <hvi/state.hpp>

namespace hvi {

/// A step that failed, where an algorithm of Boost.Odeint took it. The state is the last good one.
class StepFailure : public std::runtime_error {
public:
    explicit StepFailure(Status status) : std::runtime_error(status.message()), status_(status) {}

    [[nodiscard]] Status status() const { return status_; }

private:
    Status status_;
};

/// A stepper of Boost.Odeint for algorithms with steps of constant size, `integrate_const` and the
/// like:
///
///     hvi::Odeint<KeplerGauss4> stepper;
///     boost::numeric::odeint::integrate_const(stepper, hvi::no_system, x, 0.0, 10.0, 0.05, observe);
///
/// The stepper knows its system: the one that Odeint hands on is not looked at. NOTE: Odeint copies
/// steppers; with std::ref(stepper) a later call goes on with what this one remembers.
template <class Stepper>
class Odeint {
public:
    using state_type = typename Stepper::State;
    using deriv_type = state_type;
    using value_type = typename Stepper::Scalar;
    using time_type = value_type;
    using order_type = unsigned short;
    using stepper_category = boost::numeric::odeint::stepper_tag;

    explicit Odeint(Stepper stepper = Stepper{}) : stepper_(std::move(stepper)) {}

    /// Throws StepFailure.
    template <class System>
    void do_step(const System&, state_type& x, time_type, time_type h) {
        const Status status = stepper_.step(x, h);
        if (!status.ok()) { throw StepFailure(status); }
    }

private:
    Stepper stepper_;
};

/// For where Odeint asks for the right side of an equation.
inline constexpr struct NoSystem {
} no_system{};

}  // namespace hvi
