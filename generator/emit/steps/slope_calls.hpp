// Calls that evaluate slopes: functions of H and their arguments.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Point at which a slope is evaluated, in C++. The time is empty where H does not depend on it.
struct SlopePoint {
    std::string q, p, time = {};
};

/// Returns the state at the start of a step, in the stepper.
[[nodiscard]] SlopePoint start_of_step(const Step& step);

/// Return the call of the system, without its name and a semicolon: `dHdq(q, p, t, out)`.
[[nodiscard]] std::string force_call(const Step& step, const SlopePoint& at, std::string_view out);
[[nodiscard]] std::string velocity_call(const Step& step, const SlopePoint& at,
                                        std::string_view out);
/// Returns the call for both slopes. Precondition: they are evaluated at once.
[[nodiscard]] std::string gradient_call(const SlopePoint& at, std::string_view out_q,
                                        std::string_view out_p);

/// Returns `d2Hdq2(q, t, out)`, for a separable H.
[[nodiscard]] std::string hessian_call(const SlopePoint& at, std::string_view out);

/// Return the calls that fill the blocks of second derivatives, for any H.
[[nodiscard]] std::string hessian_qq_call(const Step& step, const SlopePoint& at,
                                          std::string_view out);
[[nodiscard]] std::string hessian_pp_call(const Step& step, const SlopePoint& at,
                                          std::string_view out);
/// Returns the call for d2H/dqdp. Precondition: H is not separable.
[[nodiscard]] std::string hessian_qp_call(const SlopePoint& at, std::string_view out);

}  // namespace hvi::gen
