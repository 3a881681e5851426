// Reserved names, and names that are free for parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// Whether `name` is one of `names`.
[[nodiscard]] bool contains(const std::vector<std::string>& names, const std::string& name);

/// Whether the name is `pi` or `e`.
[[nodiscard]] bool is_constant(std::string_view name);

/// Whether the name is reserved, with an index or without: `pi`, `e`, `tau`, `t`, `h`, or a
/// function.
[[nodiscard]] bool is_reserved(std::string_view name);

/// Whether the name has whole numbers as its indices, as the reader writes them: `x[3]`, `u[1,-2]`.
[[nodiscard]] bool is_indexed_name(const std::string& name);

/// Returns the name without its index: `x` of `x[3]`.
[[nodiscard]] std::string_view without_index(std::string_view name);

/// Throws InputError at `place`, with a name to use instead, unless `name` is a letter followed by
/// letters, digits and `_`, and is not reserved. `subject` is the thing that it would name.
void check_parameter_name(const std::string& name, const Place& place,
                          std::string_view subject = "a parameter");

/// Checks a name that can have an index, a whole number: `x[3]`. Throws as check_parameter_name().
void check_symbol_name(const std::string& name, const Place& place,
                       std::string_view subject = "a parameter");

/// Calls `visit` for the expression and everything in it. Skips the inside of an expression for
/// which `visit` returns false.
void walk(const Expression& expression, const std::function<bool(const Expression&)>& visit);

/// Adds the symbols in an expression that are parameters.
void insert_parameters(const Expression& expression, std::set<std::string>& names);

}  // namespace hvi::gen
