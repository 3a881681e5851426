// Functions of tau from text, and what their values and integrals are compared with.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/expressions/basis.hpp"
#include "tests/generator/exact/exact.hpp"

namespace hvi::gen {

/// The first function of a basis, for a method with these nodes.
inline ExactFunction function(const std::string& text, const Ground& ground,
                              const std::string& nodes = "0, 1") {
    const List basis = parse_list(source(text, "--basis"));
    NumberVector points;
    for (const Item& item : parse_list(source(nodes)).items) {
        points.push_back(evaluate_number(std::get<Expression>(item.what), source(nodes), ground));
    }
    return basis_functions(basis, points, ground).front().function;
}

/// Whether the integral over [0, end] equals `expected`, exactly.
inline bool integrates(const std::string& text, const std::string& end,
                       const std::string& expected) {
    return on_new_ground([&](const Ground& ground) {
        const Number integral =
            function(text, ground, "0, " + end).integral(read(end, ground), ground);
        return (integral - read(expected, ground)).is_zero();
    });
}

/// The integral over [0, end] to 50 digits.
inline std::string integral_digits(const std::string& text, const std::string& end) {
    return on_new_ground([&](const Ground& ground) {
        return function(text, ground, "0, " + end).integral(read(end, ground), ground).decimal(50);
    });
}

inline bool has_value(const std::string& text, const std::string& point,
                      const std::string& expected) {
    return on_new_ground([&](const Ground& ground) {
        const Number value = function(text, ground, point).at(read(point, ground), ground);
        return (value - read(expected, ground)).is_zero();
    });
}

/// The function as a constant, or `none`.
inline std::string constant(const std::string& given) {
    return on_new_ground([&](const Ground& ground) {
        const auto number = function(given, ground).constant();
        return number ? text(*number) : "none";
    });
}

inline std::size_t terms(const std::string& text) {
    return on_new_ground(
        [&](const Ground& ground) { return function(text, ground).terms().size(); });
}

}  // namespace hvi::gen
