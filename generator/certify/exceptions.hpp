// Exceptional values of a free parameter, at which a method has a higher order.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/methods/order.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// A value of a parameter at which the order is higher than for most values.
struct ExceptionalValue {
    std::string parameter;
    Number value;
    int order = 0;
    bool is_at_least = false;  ///< whether no condition failed up to the largest order asked for
};

/// Returns the values at which all the conditions hold that fail for most values: common zeros of
/// the residuals, in their order. They are sought where one parameter is free and the residuals are
/// rational functions of it over Q. Zeros at which there is no method, and those without a closed
/// form, are left out. `generic` are the conditions for a free parameter.
[[nodiscard]] std::vector<ExceptionalValue>
exceptions(const Method& method, const OrderConditions& generic, int max_order);

}  // namespace hvi::gen
