// Generated steppers in Boost.Odeint.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <utility>

#include <boost/numeric/odeint/stepper/stepper_categories.hpp>

#include <hvi/state.hpp>

namespace hvi {

/// Exception for a step that failed within an algorithm of Boost.Odeint. The state is the last good
/// one.
class StepFailure : public std::runtime_error {
public:
    explicit StepFailure(Status status) : std::runtime_error(status.message()), status_(status) {}

    [[nodiscard]] Status status() const { return status_; }

private:
    Status status_;
};

/// A stepper of Boost.Odeint for algorithms with steps of constant size, such as `integrate_const`.
/// The stepper knows its system and ignores the one that Odeint passes. NOTE: Odeint copies
/// steppers; with std::ref(stepper) a later call goes on with the memory of this stepper.
/// # Use
/// `Stepper` is a class that hvi-gen has written, and the state of Odeint is its State. Times are
/// in the units of H. The time of Odeint is for observers alone: where H depends on the time, a
/// step begins at the time x.t. A step that fails throws StepFailure, and x is the last good state.
/// ```cpp
/// #include <array>
/// #include <cmath>
///
/// #include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
/// #include <hvi/generated/stormer_verlet_separable.hpp>
/// #include <hvi/odeint.hpp>
///
/// struct Spring {  // H = p^2/2 + q^2/2
///     using Vector = std::array<double, 1>;
///     void dHdq(const Vector& q, Vector& out) const { out = q; }
///     void dHdp(const Vector& p, Vector& out) const { out = p; }
/// };
///
/// int main() {
///     hvi::Odeint<hvi::generated::StormerVerletSeparable<Spring>> stepper;
///     hvi::State<Spring::Vector> x{{1.0}, {0.0}};
///     const double h = 0.1;
///     boost::numeric::odeint::integrate_n_steps(stepper, hvi::no_system, x, 0.0, h, 100);
///     // q after n steps of the method is cos(n theta) with cos(theta) = 1 - h^2/2.
///     const double error = x.q[0] - std::cos(100 * std::acos(1 - h * h / 2));
///     bool is_named = false;
///     try {
///         stepper.do_step(hvi::no_system, x, 100 * h, HUGE_VAL);
///     } catch (const hvi::StepFailure& failure) {
///         is_named = failure.status().code() == hvi::Status::Code::not_finite;
///     }
///     return std::abs(error) < 1e-12 && is_named ? 0 : 1;
/// }
/// ```
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

    /// Advances x by a step of size h. Throws StepFailure where the step fails.
    template <class System>
    void do_step(const System&, state_type& x, time_type, time_type h) {
        const Status status = stepper_.step(x, h);
        if (!status.ok()) { throw StepFailure(status); }
    }

private:
    Stepper stepper_;
};

/// Argument for Odeint's parameter `system`, which Odeint<Stepper> ignores.
inline constexpr struct NoSystem {
} no_system{};

}  // namespace hvi
