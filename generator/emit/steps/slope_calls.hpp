// The calls that evaluate slopes: which function of H, with which arguments.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Where a slope is evaluated, in C++. The time is empty where H does not depend on it.
struct SlopePoint {
    std::string q, p, time = {};
};

/// The state where a step begins, in the stepper.
[[nodiscard]] SlopePoint start_of_step(const Step& step);

/// The call of the system, without its name and a semicolon: `dHdq(q, p, t, out)`.
[[nodiscard]] std::string force_call(const Step& step, const SlopePoint& at, std::string_view out);
[[nodiscard]] std::string velocity_call(const Step& step, const SlopePoint& at,
                                        std::string_view out);
/// Precondition: both slopes are evaluated at once.
[[nodiscard]] std::string gradient_call(const SlopePoint& at, std::string_view out_q,
                                        std::string_view out_p);

/// `d2Hdq2(q, t, out)`, of a separable H.
[[nodiscard]] std::string hessian_call(const SlopePoint& at, std::string_view out);

/// The calls that fill the blocks of second derivatives, of any H.
[[nodiscard]] std::string hessian_qq_call(const Step& step, const SlopePoint& at,
                                          std::string_view out);
[[nodiscard]] std::string hessian_pp_call(const Step& step, const SlopePoint& at,
                                          std::string_view out);
/// Precondition: H is not separable.
[[nodiscard]] std::string hessian_qp_call(const SlopePoint& at, std::string_view out);

}  // namespace hvi::gen
