// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/slope_calls.hpp"

#include <fmt/format.h>

#include <initializer_list>

#include "generator/emit/steps/clock.hpp"

namespace hvi::gen {
namespace {

std::string call(std::string_view function, std::initializer_list<std::string_view> arguments) {
    std::string list;
    for (const std::string_view argument : arguments) {
        if (argument.empty()) { continue; }
        list += fmt::format("{}{}", list.empty() ? "" : ", ", argument);
    }
    return fmt::format("{}({})", function, list);
}

}  // namespace

SlopePoint start_of_step(const Step& step) {
    return {"s_.at.q", "s_.at.p", time_of_start(step, "s_")};
}

std::string force_call(const Step& step, const SlopePoint& at, std::string_view out) {
    return call("dHdq", {at.q, step.is_separable() ? "" : at.p, at.time, out});
}

std::string velocity_call(const Step& step, const SlopePoint& at, std::string_view out) {
    if (step.is_separable()) { return call("dHdp", {at.p, out}); }
    return call("dHdp", {at.q, at.p, at.time, out});
}

std::string gradient_call(const SlopePoint& at, std::string_view out_q, std::string_view out_p) {
    return call("gradient", {at.q, at.p, at.time, out_q, out_p});
}

std::string hessian_call(const SlopePoint& at, std::string_view out) {
    return call("d2Hdq2", {at.q, at.time, out});
}

std::string hessian_qq_call(const Step& step, const SlopePoint& at, std::string_view out) {
    return step.is_separable() ? hessian_call(at, out) : call("d2Hdq2", {at.q, at.p, at.time, out});
}

std::string hessian_pp_call(const Step& step, const SlopePoint& at, std::string_view out) {
    if (step.is_separable()) { return call("d2Hdp2", {at.p, out}); }
    return call("d2Hdp2", {at.q, at.p, at.time, out});
}

std::string hessian_qp_call(const SlopePoint& at, std::string_view out) {
    return call("d2Hdqdp", {at.q, at.p, at.time, out});
}

}  // namespace hvi::gen
