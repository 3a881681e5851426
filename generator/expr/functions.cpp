// The table of functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/functions.hpp"

#include <algorithm>
#include <array>

namespace hvi::gen {

namespace {

constexpr Function of_two(std::string_view name, std::string_view latex, Nature nature,
                          std::string_view derivative, std::string_view by_second = "") {
    Function result{name, 2, latex, nature};
    result.derivative = derivative;
    result.by_second = by_second;
    return result;
}

constexpr Function of_small_turns(std::string_view name, std::string_view derivative) {
    Function result{name, 1, ""};
    result.parity = Parity::odd;
    result.runtime = Runtime::small_turns;
    result.derivative = derivative;
    return result;
}

constexpr std::array table{
#define HVI_FUNCTION(name, latex, domain, cuts, parity, runtime, derivative)                       \
    Function{#name,                                                                                \
             1,                                                                                    \
             latex,                                                                                \
             Nature::analytic,                                                                     \
             RealDomain::domain,                                                                   \
             Cuts::cuts,                                                                           \
             Parity::parity,                                                                       \
             Runtime::runtime,                                                                     \
             derivative},
#define HVI_FUNCTION_OF_TWO(name, latex, by_a, by_b)                                               \
    of_two(#name, latex, Nature::analytic, by_a, by_b),
#define HVI_KINK(name, latex, derivative)                                                          \
    Function{#name,                                                                                \
             1,                                                                                    \
             latex,                                                                                \
             Nature::kink,                                                                         \
             RealDomain::everywhere,                                                               \
             Cuts::nowhere,                                                                        \
             Parity::neither,                                                                      \
             Runtime::more_math,                                                                   \
             derivative},
#define HVI_CHOICE(name, latex, written) of_two(#name, latex, Nature::choice, written),
#include "generator/expr/functions.def"
    Function{"if<", 4, "", Nature::choice},
    Function{"if<=", 4, "", Nature::choice},
    of_small_turns("tan<", "1+y^2"),
    of_small_turns("sin2<", "2*cos(2*x)"),
    Function{"roots", 1, "\\operatorname{roots}", Nature::list},
    Function{"bspline", 2, "\\operatorname{bspline}", Nature::list},
};

}  // namespace

std::span<const Function> functions() { return table; }

bool is_if(std::string_view name) { return name == "if<" || name == "if<="; }

bool is_hidden(std::string_view name) { return name.find('<') != std::string_view::npos; }

bool is_of_lists(std::string_view name) {
    const Function* const function = find_function(name);
    return function != nullptr && function->nature == Nature::list;
}

bool is_function(std::string_view word) { return word == "if" || find_function(word) != nullptr; }

bool is_choice(std::string_view name) {
    const Function* const function = find_function(name);
    return function != nullptr && function->nature == Nature::choice;
}

bool is_smooth(std::string_view name) {
    const Function* const function = find_function(name);
    return function == nullptr || function->is_smooth();
}

const Function* find_function(std::string_view name) {
    const auto* found = std::find_if(table.begin(), table.end(),
                                     [&](const Function& entry) { return entry.name == name; });
    return found == table.end() ? nullptr : found;
}

}  // namespace hvi::gen
