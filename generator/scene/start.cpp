// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/scene/start.hpp"

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/functions/division_by_zero.hpp"
#include "generator/scene/rotation_start.hpp"

namespace hvi::gen {

namespace {

MathError no_value(const Parameter& parameter, const std::string& fault,
                   const std::optional<Place>& place) {
    return MathError("in the value of `" + parameter.name + "` there is " + fault, place);
}

Ball value_of(const Parameter& parameter) {
    try {
        return value_at(parameter.value, {}, parameter.source);
    } catch (const MathError& error) { throw no_value(parameter, error.what(), error.place()); }
}

/// Throws MathError where a value is beyond the range of doubles, or is not 0 and smaller than
/// 2^-900, below which values cannot be written as sums of doubles.
void check_range(const Ball& value, const std::string& name, const Place& place) {
    Ball one, size, infinite_from, least;
    arb_set_si(one.get(), 1);
    arb_abs(size.get(), value.get());
    arb_mul_2exp_si(infinite_from.get(), one.get(), 54);  // 2^1024 less half of a last place
    arb_sub(infinite_from.get(), infinite_from.get(), one.get(), 64);
    arb_mul_2exp_si(infinite_from.get(), infinite_from.get(), 1024 - 54);
    arb_mul_2exp_si(least.get(), one.get(), -900);
    const bool is_large = arb_ge(size.get(), infinite_from.get()) != 0;
    const bool is_small = arb_lt(size.get(), least.get()) != 0;
    if (is_large || (is_small && arb_contains_zero(value.get()) == 0))
        throw MathError("the value of `" + name + "` is beyond the range of coefficients", place,
                        "choose other units");
}

}  // namespace

Number exact_value(const Parameter& parameter, const Ground& ground) {
    static_cast<void>(value_of(parameter));
    try {
        return evaluate_number(parameter.value, parameter.source, ground);
    } catch (const DivisionByZero& error) {
        throw no_value(parameter, "a division by zero", error.place());
    }
}

SymbolValues parameter_values(const WrittenOutScene& scene) {
    SymbolValues values;
    for (const Parameter& parameter : scene.parameters) {
        values[parameter.name] = value_of(parameter);
    }
    return values;
}

void check_start(const WrittenOutScene& scene) {
    const SymbolValues values = parameter_values(scene);
    for (const Parameter& parameter : scene.parameters) {
        on_new_ground([&](const Ground& ground) { return exact_value(parameter, ground); });
        check_range(values.at(parameter.name), parameter.name,
                    {parameter.source, parameter.value.range});
    }
    if (scene.initial.empty()) { return; }
    const auto look = [](const NamedExpression& what, const SymbolValues& at) {
        return value_at(what.expression, at, what.place.source);
    };
    SymbolValues start = values;
    try {
        for (const NamedExpression& initial : scene.initial) {
            start[initial.name] = look(initial, values);
        }
        start["t"] = Ball();
        const MechanicalFunction& function = function_of(scene);
        (void)value_at(function.expression, start, function.source);
        for (const NamedExpression& invariant : scene.invariants) { (void)look(invariant, start); }
    } catch (const MathError& error) {
        throw MathError(std::string("where the scene begins there is ") + error.what(),
                        error.place(), "mend the initial data, or the values of parameters");
    }
    check_rotations(scene, start);
    for (const NamedExpression& initial : scene.initial)
        check_range(start.at(initial.name), initial.name, initial.place);
}

std::vector<double> exact_state(const WrittenOutScene& scene, double time) {
    SymbolValues values = parameter_values(scene);
    arb_set_d(values["t"].get(), time);
    std::vector<double> state;
    for (const NamedExpression& variable : scene.exact) {
        const Ball value = value_at(variable.expression, values, variable.place.source);
        if (!arb_is_finite(value.get())) {
            throw MathError("the exact solution has no known value at t = " + std::to_string(time),
                            variable.place);
        }
        state.push_back(arf_get_d(arb_midref(value.get()), ARF_RND_NEAR));
    }
    return state;
}

}  // namespace hvi::gen
