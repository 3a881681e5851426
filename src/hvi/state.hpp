// The state that a stepper advances, and what a step says about itself.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone, because generated headers without a solver carry a copy
// of this file. The guard, not `#pragma once`, lets the copy and the file meet in either order.
#ifndef HVI_STATE_HPP
#define HVI_STATE_HPP

namespace hvi {

/// Positions q and momenta p, of the same dimension.
/// # Use
/// `Vector` is std::array<T, n> or a vector of Eigen, fixed or dynamic, and T is float, double,
/// long double or __float128. p[k] is the momentum of q[k]. Units are the caller's: the unit of
/// q[k] p[k] is that of H times that of h. A stepper advances a state by the time h. A step fails
/// where a value is not finite, q and p differ in dimension, or the equations of the step are not
/// solved. It then throws nothing: its Status says why, and the state has kept its bits.
/// ```cpp
/// #include <array>
/// #include <cmath>
/// #include <cstdio>
///
/// #include <hvi/generated/stormer_verlet_separable.hpp>
///
/// struct Spring {  // H = p^2/2 + q^2/2
///     using Vector = std::array<double, 1>;
///     void dHdq(const Vector& q, Vector& out) const { out = q; }
///     void dHdp(const Vector& p, Vector& out) const { out = p; }
/// };
///
/// int main() {
///     const double h = 0.1;
///     hvi::generated::StormerVerletSeparable<Spring> stepper;
///     hvi::State<Spring::Vector> x{{1.0}, {0.0}};  // q = 1, p = 0
///     for (int step = 0; step < 1000; ++step) {
///         if (const hvi::Status status = stepper.step(x, h); !status.ok()) {
///             std::puts(status.message());
///             return 1;
///         }
///     }
///     // The method conserves p^2 + (1 - h^2/4) q^2, which was 1 - h^2/4.
///     const double w2 = 1 - h * h / 4;
///     const double error = x.p[0] * x.p[0] + w2 * x.q[0] * x.q[0] - w2;
///
///     const hvi::State<Spring::Vector> before = x;
///     const bool is_refused = stepper.step(x, HUGE_VAL).code() == hvi::Status::Code::not_finite;
///     const bool is_kept = x.q == before.q && x.p == before.p;
///     return std::abs(error) < 1e-13 && is_refused && is_kept ? 0 : 1;
/// }
/// ```
template <class Vector>
struct State {
    Vector q{};
    Vector p{};
};

/// Result of a step. Unless it is ok, the state has kept its bits.
class [[nodiscard]] Status {
public:
    enum class Code {
        ok,
        not_converged,        ///< the stage equations have no solution nearby: try a smaller h
        not_finite,           ///< h, the state or a derivative of H is infinite or not a number
        singular,             ///< the linear system of Newton's method is singular at this h
        dimension_mismatch,   ///< q and p differ in dimension
        unsafe_arithmetic,    ///< compiled with -ffast-math or the like
        pole,                 ///< the method does not exist at this parameter, or very near it
        zero_weight,          ///< a weight is zero at this parameter, or very near it
        parameter_too_large,  ///< the coefficients are not computed so far out
        not_a_rotation,       ///< a matrix of the state is no rotation
        outside_chart,        ///< a body turns by 2 pi or more in the step: try a smaller h
    };

    constexpr Status() = default;
    constexpr explicit Status(Code what, int sweeps = 0) : iterations(sweeps), code_(what) {}

    [[nodiscard]] constexpr bool ok() const { return code_ == Code::ok; }
    [[nodiscard]] constexpr Code code() const { return code_; }

    /// Returns one line without a full stop, for people.
    [[nodiscard]] constexpr const char* message() const {
        switch (code_) {
        case Code::ok: return "ok";
        case Code::not_converged: return "the stage equations did not converge: try a smaller step";
        case Code::not_finite: return "the step met a value that is infinite or not a number";
        case Code::singular: return "the stage equations are singular at this step size";
        case Code::dimension_mismatch: return "q and p differ in dimension";
        case Code::unsafe_arithmetic:
            return "compiled with reordered floating-point sums (-ffast-math)";
        case Code::pole: return "there is no method at, or very near, this value of the parameter";
        case Code::zero_weight:
            return "a weight of the method is zero at, or very near, this value of the parameter";
        case Code::parameter_too_large: return "the parameter of the method is too large";
        case Code::not_a_rotation: return "a matrix of the state is not a rotation";
        case Code::outside_chart:
            return "a body turns by a whole turn or more in a step: try a smaller step";
        }
        return "unknown status";
    }

    int iterations = 0;  ///< of the solver, over all coupled stages; 0 where none is needed

private:
    Code code_ = Code::ok;
};

}  // namespace hvi

#endif  // HVI_STATE_HPP
