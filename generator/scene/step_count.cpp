// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/scene/step_count.hpp"

#include <cmath>
#include <initializer_list>
#include <set>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/read/names.hpp"
#include "generator/scene/start.hpp"

namespace hvi::gen {

namespace {

constexpr double most_steps = 1e15;

/// Returns the largest integer that is not above the number. Precondition: it fits.
std::int64_t floor(const Number& number) {
    const auto nearest = static_cast<std::int64_t>(std::nearbyint(number.nearest_double()));
    const auto is_above = [&](std::int64_t integer) {
        return (number - Number(static_cast<long>(integer))).sign() < 0;
    };
    return is_above(nearest) ? nearest - 1 : is_above(nearest + 1) ? nearest : nearest + 1;
}

/// Returns the ground with the values of parameters. NOTE: a list may be long, so only its values
/// that occur in these expressions are read.
Ground with_parameters(Ground ground, const SceneTimes& times,
                       std::initializer_list<const NamedExpression*> expressions) {
    std::set<std::string> names;
    for (const NamedExpression* each : expressions) insert_parameters(each->expression, names);
    for (const Parameter& parameter : times.parameters) {
        if (is_indexed_name(parameter.name) && names.count(parameter.name) == 0) continue;
        ground.set_parameter(parameter.name, exact_value(parameter, ground));
    }
    return ground;
}

Number value_of(const NamedExpression& what, const Ground& ground) {
    return evaluate_number(what.expression, what.place.source, ground);
}

/// Returns the nearest double. Throws MathError where that is infinite, or 0 and the number is not.
double nearest_or_refused(const Number& number, const Place& place) {
    const double nearest = number.nearest_double();
    if (!std::isfinite(nearest) || (nearest == 0 && number.sign() != 0))
        throw MathError("this number is beyond the range of doubles", place, "choose other units");
    return nearest;
}

Steps steps_on(const Ground& ground, const NamedExpression& step, const NamedExpression& until) {
    const Number h = value_of(step, ground);
    const Number end = value_of(until, ground);
    if (h.sign() == 0) throw MathError("the step has the size 0", step.place);
    const double size = nearest_or_refused(h, step.place);
    nearest_or_refused(end, until.place);
    const Number quotient = end / h;
    if (quotient.sign() < 0)
        throw MathError("steps of this size lead away from the end of the run", step.place,
                        "step and until have the same sign");
    if (quotient.nearest_double() > most_steps)
        throw MathError("these are more than 10^15 steps", step.place);
    const std::int64_t count = floor(quotient);
    const Number left = end - Number(static_cast<long>(count)) * h;
    return {size, count, left.sign() == 0 ? 0 : left.nearest_double()};
}

}  // namespace

Steps steps_until(const SceneTimes& times, const NamedExpression& step,
                  const NamedExpression& until) {
    return on_new_ground([&](const Ground& ground) {
        return steps_on(with_parameters(ground, times, {&step, &until}), step, until);
    });
}

double nearest_value(const SceneTimes& times, const NamedExpression& what) {
    return on_new_ground([&](const Ground& ground) {
        return nearest_or_refused(value_of(what, with_parameters(ground, times, {&what})),
                                  what.place);
    });
}

}  // namespace hvi::gen
