// Functions of the user's own, which C++ knows and algebra does not.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// How many arguments each of them takes, by its name.
using OwnArguments = std::map<std::string, std::size_t, std::less<>>;

/// Whether a function is one, or a derivative of one: what is none of functions.hpp.
[[nodiscard]] bool is_own_function(std::string_view name);

/// The derivative by argument number k, 0, 1, ..., of `V`, or of its first derivative: `V_1`, and
/// `V_12` whichever of the two comes first. Precondition: `name` is no second derivative.
[[nodiscard]] std::string own_derivative(std::string_view name, std::size_t k);

/// `V` of `V`, `V_1` and `V_12`.
[[nodiscard]] std::string_view without_derivatives(std::string_view name);

/// The first call of one in an expression, or null.
[[nodiscard]] const Expression* own_call_in(const Expression& expression);

}  // namespace hvi::gen
