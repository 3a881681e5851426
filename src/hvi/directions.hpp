// Directions that a stepper carries along, and covectors that it pulls back.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include <hvi/detail/directions/carried_along.hpp>
#include <hvi/detail/directions/carried_apart.hpp>
#include <hvi/detail/directions/moves_along.hpp>
#include <hvi/detail/directions/stages_along.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// How covectors are pulled back.
enum class PullBack {
    step_back,  ///< by a step back: the method is its own adjoint
    columns,    ///< by the derivative of the step, column by column
};

/// `Stepper` is a stepper of a scene. `Carrier` carries directions along: the same class, whose
/// steps do, or one of the same method for the motion together with a direction. `hvi-gen stepper
/// --tangent` writes both, and a name for this class.
///
/// A step takes a state x to Phi(x). It takes a direction d at x to D d, where D is the derivative
/// of Phi at x, exactly but for rounding: the method is applied to K = H_q dq + H_p dp, which moves
/// (q, p) as H does and (dq, dp) by the linearised equations, and differentiation commutes with
/// it. So D^T J D = J, as of the flow itself.
/// # Use
/// Directions and covectors are states: q of a direction is dq and p is dp; q and p of a covector
/// are the derivatives of a function by q and p. x moves with the bits of a step without
/// directions. Unless the status is ok, x, the directions and the covector have kept their bits. A
/// step allocates where there are more directions than ever before. With the header of
///
///     hvi-gen stepper --method gauss:2 pendulum --tangent -o pendulum_tangent.hpp
///
/// this is a program, which differentiates the angle at the end by where it began:
/// ```cpp
/// #include <cmath>
/// #include <cstddef>
/// #include <vector>
///
/// #include <pendulum_tangent.hpp>
///
/// using Pendulum = hvi::generated::PendulumGauss2;  // H = p^2/2 - cos(q)
///
/// int main() {
///     const double h = 0.1;
///     Pendulum pendulum;
///     std::vector<Pendulum::State> x(1);
///     x[0].q[0] = 1;
///     std::vector<Pendulum::State> D(2);  // the columns of the derivative
///     D[0].q[0] = D[1].p[0] = 1;
///     for (int step = 0; step < 100; ++step) {
///         x.push_back(x.back());
///         if (!pendulum.step(x.back(), D, h).ok()) { return 1; }
///     }
///
///     Pendulum::State lambda;
///     lambda.q[0] = 1;  // the derivative of q by q and p at the end
///     for (std::size_t step = 100; step-- > 0;) {
///         if (!pendulum.pull_back(x[step], lambda, h).ok()) { return 1; }
///     }
///     // Now it is that by q and p at the start, as the first row of D is.
///     const double error = std::abs(lambda.q[0] - D[0].q[0]) + std::abs(lambda.p[0] - D[1].q[0]);
///     const double area = D[0].q[0] * D[1].p[0] - D[1].q[0] * D[0].p[0];
///     return error < 1e-12 && std::abs(area - 1) < 1e-12 ? 0 : 1;
/// }
/// ```
template <class Stepper, class Carrier, PullBack pulls_back>
class WithDirections : public Stepper {
public:
    using State = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;
    using Parameters = typename Stepper::Parameters;

    WithDirections() : WithDirections(Parameters{}) {}

    /// `more` is what the constructor of the stepper takes beside its parameters.
    template <class... More>
    explicit WithDirections(const Parameters& parameters, const More&... more)
        : Stepper(parameters, more...),
          probe_(parameters, more...),
          ahead_(Carrier(parameters, more...)),
          back_(Carrier(parameters, more...)) {}

    using Stepper::step;

    /// Advances x by a step of size h, and carries directions at x along: so many states d[k],
    /// whose number is std::size(d).
    template <class Directions>
    [[nodiscard]] Status step(State& x, Directions& d, Scalar h) {
        if (h == 0) { return {}; }
        for (const State& each : d) {
            if (!fits(x, each)) { return Status(Status::Code::dimension_mismatch); }
        }
        return ahead_.advance(static_cast<Stepper&>(*this), x, d, h);
    }

    /// Takes the derivative of a function by the state after the step of size h from x to that by
    /// x: lambda becomes D^T lambda. For any direction d at x, the products of lambda after the
    /// step with D d and before it with d are equal, to rounding.
    [[nodiscard]] Status pull_back(const State& x, State& lambda, Scalar h) {
        if (h == 0) { return {}; }
        if (!fits(x, lambda)) { return Status(Status::Code::dimension_mismatch); }
        if constexpr (pulls_back == PullBack::step_back) {
            return step_back(x, lambda, h);
        } else {
            return pull_back_columns(x, lambda, h);
        }
    }

    /// Forgets what the last step left; see the stepper.
    void reset() {
        Stepper::reset();
        probe_.reset();
        ahead_.reset();
        back_.reset();
    }

private:
    [[nodiscard]] static bool fits(const State& x, const State& d) {
        return x.q.size() == d.q.size() && x.p.size() == d.p.size();
    }

    /// D^T = J D^-1 J^-1, where D^-1 is the derivative of the step back.
    [[nodiscard]] Status step_back(const State& x, State& lambda, Scalar h) {
        State end = x;
        const Status status = probe_.step(end, h);
        if (!status.ok()) { return status; }
        moved_.assign(1, lambda);
        turn(moved_.front(), lambda, -1);
        const Status carried = back_.step(end, moved_, -h);
        if (carried.ok()) { turn(lambda, moved_.front(), 1); }
        return carried;
    }

    /// (q, p) of `out` become (p, -q) of v, by the sign.
    static void turn(State& out, const State& v, int sign) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(v.q.size()); ++k) {
            detail::at(out.q, k) = static_cast<Scalar>(sign) * detail::at(v.p, k);
            detail::at(out.p, k) = static_cast<Scalar>(-sign) * detail::at(v.q, k);
        }
    }

    /// Multiplies by the columns of D, one for each component of the state.
    [[nodiscard]] Status pull_back_columns(const State& x, State& lambda, Scalar h) {
        const std::size_t degrees = static_cast<std::size_t>(x.q.size());
        State zero = lambda;
        for (std::size_t k = 0; k < degrees; ++k) {
            detail::at(zero.q, k) = detail::at(zero.p, k) = 0;
        }
        moved_.assign(2 * degrees, zero);
        for (std::size_t k = 0; k < degrees; ++k) {
            detail::at(moved_[k].q, k) = 1;
            detail::at(moved_[degrees + k].p, k) = 1;
        }
        const Status status = back_.step(x, moved_, h);
        if (!status.ok()) { return status; }
        State result = lambda;
        for (std::size_t k = 0; k < degrees; ++k) {
            detail::at(result.q, k) = product(lambda, moved_[k]);
            detail::at(result.p, k) = product(lambda, moved_[degrees + k]);
        }
        lambda = result;
        return status;
    }

    [[nodiscard]] static Scalar product(const State& lambda, const State& d) {
        Scalar sum = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(d.q.size()); ++k) {
            sum += detail::at(lambda.q, k) * detail::at(d.q, k);
            sum += detail::at(lambda.p, k) * detail::at(d.p, k);
        }
        return sum;
    }

    using Carriers =
        std::conditional_t<std::is_same_v<Carrier, Stepper>, detail::CarriedAlong<Stepper>,
                           detail::CarriedApart<Carrier, State>>;

    Stepper probe_;  ///< finds where the step ends that a covector is pulled back along
    Carriers ahead_, back_;
    std::vector<State> moved_;
};

}  // namespace hvi
