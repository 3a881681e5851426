// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/exceptions.hpp"

#include "generator/exact/algebra/common_zeros.hpp"
#include "generator/exact/methods/galerkin_form.hpp"
#include "generator/exact/methods/rule_properties.hpp"

namespace hvi::gen {

namespace {

OrderConditions conditions(const Tableau& tableau, int max_order) {
    return orders(tableau, max_order).general;
}

OrderConditions conditions(const GalerkinRule& rule, int max_order) {
    return nystrom_order(rule, max_order);
}

/// Returns the order for a value of the parameter; empty where there is no method.
std::optional<ExceptionalValue> exception_at(Method method, const std::string& name,
                                             const Number& value, int max_order) {
    const auto form = value.closed_form();
    if (!form) { return {}; }
    const Given source = given("--param", name);
    set_parameter(method, {name, *form, whole(source), source});
    try {
        const OrderConditions there =
            std::visit([&](const auto& derived) { return conditions(derived, max_order); },
                       derive_any(method));
        return ExceptionalValue{name, value, there.order, there.is_at_least};
    } catch (const MathError&) { return {}; }
}

}  // namespace

std::vector<ExceptionalValue> exceptions(const Method& method, const OrderConditions& generic,
                                         int max_order) {
    std::vector<Number> residuals;
    for (const FailedCondition& failure : generic.failures) {
        residuals.push_back(failure.residual);
    }
    if (residuals.empty()) { return {}; }
    const auto zeros = common_zeros(residuals);
    if (!zeros) { return {}; }
    std::vector<ExceptionalValue> result;
    for (const Number& zero : zeros->values) {
        auto exception = exception_at(method, zeros->parameter, zero, max_order);
        if (exception) { result.push_back(*std::move(exception)); }
    }
    return result;
}

}  // namespace hvi::gen
