// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/own_functions.hpp"

#include <algorithm>

#include "generator/expr/functions.hpp"

namespace hvi::gen {

/// NOTE: `mod` stands in indices only.
bool is_own_function(std::string_view name) {
    return find_function(name) == nullptr && name != "mod";
}

/// NOTE: no function has the name of a derivative; see generator/read/own_functions.cpp.
std::string_view without_derivatives(std::string_view name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    const bool is_derivative =
        end != std::string_view::npos && end + 1 < name.size() && name[end] == '_';
    return is_derivative ? name.substr(0, end) : name;
}

std::string own_derivative(std::string_view name, std::size_t k) {
    constexpr std::size_t most_derivatives = 2;
    const std::string_view stem = without_derivatives(name);
    std::string numbers(name.substr(std::min(stem.size() + 1, name.size())));
    HVI_CHECK(k < 9 && numbers.size() < most_derivatives);
    numbers += static_cast<char>('1' + k);
    std::sort(numbers.begin(), numbers.end());
    return std::string(stem) + "_" + numbers;
}

const Expression* own_call_in(const Expression& expression) {
    if (expression.kind == Expression::Kind::call && is_own_function(expression.name)) {
        return &expression;
    }
    for (const Expression& argument : expression.arguments) {
        if (const Expression* const found = own_call_in(argument)) { return found; }
    }
    return nullptr;
}

}  // namespace hvi::gen
