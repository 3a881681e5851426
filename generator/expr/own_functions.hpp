// The user's own functions, which C++ knows and algebra does not.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// The numbers of arguments of own functions, by name.
using OwnArguments = std::map<std::string, std::size_t, std::less<>>;

/// Whether the name is an own function or a derivative of one: it is not in functions.hpp.
[[nodiscard]] bool is_own_function(std::string_view name);

/// Returns the name of a derivative by argument number k, 0, 1, ...: `V_1` for `V`, and `V_12` for
/// its first derivatives in either order. Precondition: `name` is no second derivative.
[[nodiscard]] std::string own_derivative(std::string_view name, std::size_t k);

/// Returns `V` for `V`, `V_1` and `V_12`.
[[nodiscard]] std::string_view without_derivatives(std::string_view name);

/// Returns the first call of an own function in an expression, or null.
[[nodiscard]] const Expression* own_call_in(const Expression& expression);

}  // namespace hvi::gen
