// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/increments.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

std::string factor(const Step& step, const StageValue& value, std::string_view letter,
                   const std::string& weights, std::size_t index, std::string_view s) {
    if (rounds_weights(step)) { return fmt::format("{}.hb_{}[{}]", s, letter, index); }
    if (equal(value.weight, 1)) { return fmt::format("{}.h", s); }
    return fmt::format("{}.h * {}{}[{}]", s, owner(step, s), weights, index);
}

}  // namespace

bool is_merged(const Step& step) {
    for (const auto* values : {&step.positions, &step.momenta}) {
        for (const StageValue& value : *values) {
            if (value.stages.size() > 1) { return true; }
        }
    }
    return false;
}

Constant weight(const StageValue& value) {
    std::string name;
    for (const std::size_t stage : value.stages) {
        name += fmt::format("{}b_{}", name.empty() ? "" : "+", stage + 1);
    }
    return {name, nearest(value.weight), exact_text(value.weight)};
}

std::vector<Constant> weights(const std::vector<StageValue>& values) {
    std::vector<Constant> result;
    for (const StageValue& value : values) { result.push_back(weight(value)); }
    return result;
}

std::string weights_q(const Step& step) { return is_merged(step) ? "b_q" : "b"; }
std::string weights_p(const Step& step) { return is_merged(step) ? "b_p" : "b"; }
std::string_view table_mt(const Step& step) { return step.partner == Partner::same ? "m" : "mt"; }

std::string_view owner(const Step& step, std::string_view s) {
    if (!step.from_parameter) { return ""; }
    return s == "s_" ? "coefficients_." : "c.";
}

bool rounds_weights(const Step& step) {
    for (const auto* values : {&step.positions, &step.momenta}) {
        for (const StageValue& value : *values) {
            if (!is_power_of_two(value.weight)) { return true; }
        }
    }
    return false;
}

std::string moved_position(const Step& step, std::size_t i, std::string_view s) {
    Increment increment;
    for (std::size_t j = 0; j < step.momenta.size(); ++j) {
        increment.add(step.m[i][j], fmt::format("{}m[{}][{}]", owner(step, s), i, j),
                      fmt::format("{}.Lq[{}][k]", s, j));
    }
    return moved("q", "e_q", increment.text());
}

std::string moved_momentum(const Step& step, std::size_t j, std::string_view s) {
    Increment increment;
    for (std::size_t i = 0; i < step.positions.size(); ++i) {
        increment.add(Number(1) - step.m[i][j],
                      fmt::format("{}{}[{}][{}]", owner(step, s), table_mt(step), j, i),
                      fmt::format("{}.Lp[{}][k]", s, i));
    }
    return moved("p", "e_p", increment.text());
}

namespace {

/// Returns the C++ name of the values of stage i. NOTE: the ends of a separable step are the state.
std::string value_of(const Step& step, const StageValue& value, std::string_view letter,
                     std::size_t i, std::string_view s) {
    const bool is_state = step.is_separable() && value.place != StageValue::Place::inner;
    return is_state ? fmt::format("{}.at.{}", s, letter == "Q" ? "q" : "p")
                    : fmt::format("{}.{}[{}]", s, letter, i);
}

}  // namespace

std::string evaluate_velocity(const Step& step, std::size_t j, std::string_view s) {
    return velocity_call(step,
                         {fmt::format("{}.Q[{}]", s, j), value_of(step, step.momenta[j], "P", j, s),
                          time_of_stage(step, std::to_string(j), s)},
                         "slope") +
           ";";
}

std::string evaluate_force(const Step& step, std::size_t i, std::string_view s) {
    return force_call(step,
                      {value_of(step, step.positions[i], "Q", i, s), fmt::format("{}.P[{}]", s, i),
                       time_of_stage(step, std::to_string(i), s)},
                      "slope") +
           ";";
}

std::string velocity_factor(const Step& step, std::size_t j, std::string_view s) {
    return factor(step, step.momenta[j], "q", weights_q(step), j, s);
}

std::string force_factor(const Step& step, std::size_t i, std::string_view s) {
    return "-" + factor(step, step.positions[i], "p", weights_p(step), i, s);
}

}  // namespace hvi::gen
