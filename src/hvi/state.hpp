// The state that a stepper advances, and what a step says about itself.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone, because generated headers without a solver carry a copy
// of this file. The guard, not `#pragma once`, lets the copy and the file meet in either order.
#ifndef HVI_STATE_HPP
#define HVI_STATE_HPP

namespace hvi {

/// Positions q and momenta p, of the same dimension.
template <class Vector>
struct State {
    Vector q{};
    Vector p{};
};

/// What became of a step. Unless it is ok, the state has kept its bits.
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
    };

    constexpr Status() = default;
    constexpr explicit Status(Code what, int sweeps = 0) : iterations(sweeps), code_(what) {}

    [[nodiscard]] constexpr bool ok() const { return code_ == Code::ok; }
    [[nodiscard]] constexpr Code code() const { return code_; }

    /// One line without a full stop, for people.
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
        }
        return "unknown status";
    }

    int iterations = 0;  ///< of the solver, over all coupled stages; 0 where none is needed

private:
    Code code_ = Code::ok;
};

}  // namespace hvi

#endif  // HVI_STATE_HPP
