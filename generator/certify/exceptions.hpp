// Where a method with a free parameter is better than for most values of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/methods/order.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// For this value of the parameter the order is higher than the generic one.
struct ExceptionalValue {
    std::string parameter;
    Number value;
    int order = 0;
    bool is_at_least = false;  ///< nothing failed up to the largest order asked for
};

/// The values at which all the conditions hold that fail for most: common zeros of the residuals,
/// by the value. Looked for where one parameter is free and the residuals are rational functions of
/// it over Q; of the zeros those are left out at which there is no method, and those without a
/// closed form. `generic` are the conditions of the method as it is.
[[nodiscard]] std::vector<ExceptionalValue>
exceptions(const Method& method, const OrderConditions& generic, int max_order);

}  // namespace hvi::gen
