// Maps of the oscillator and stability of methods given as text, and what they are compared with.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/exact/algebra/number_polynomial.hpp"
#include "generator/exact/methods/stability.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "tests/generator/exact/exact.hpp"

namespace hvi::gen {

inline OscillatorMap map_of(const std::string& given) {
    return oscillator_map(derive(any_method(given)));
}

/// Whether the map is proved to have determinant 1.
inline bool proved_one(const OscillatorMap& map) {
    return map.determinant_one.holds && map.determinant_one.proved;
}

inline LinearStability stability_of(const std::string& given) {
    return linear_stability(map_of(given), 20);
}

/// `(0, 2*sqrt(2)) [2, 3]`: the intervals with closed forms for ends, or 10 digits.
inline std::string ends(const LinearStability& stability) {
    const auto end = [](const Number& number) {
        return text(number) == "none" ? number.decimal(10) : text(number);
    };
    std::string result;
    for (const StabilityInterval& interval : stability.stable) {
        if (!result.empty()) { result += ' '; }
        result += interval.low_included ? '[' : '(';
        result += end(interval.low) + ", " + end(interval.high);
        result += interval.high_included ? ']' : ')';
    }
    return result;
}

/// To 38 digits behind the point. NOTE: by enclosures, because the numbers' fields differ.
inline bool agrees(const Number& left, const std::string& right) {
    const Number enclosed = number(Real([left](Precision bits) { return enclosure(left, bits); }));
    const Number difference = enclosed - number(right);
    const Number unit = number("1e-38");
    return (unit - difference).sign() > 0 && (unit + difference).sign() > 0;
}

/// A polynomial in z as it is written.
inline NumberPolynomial read_polynomial(std::string text, const Ground& ground) {
    for (std::size_t at = 0; (at = text.find('z', at)) != std::string::npos; at += 3) {
        text.replace(at, 1, "tau");
    }
    const auto given = source(text);
    return evaluate_function(parse_expression(given), given, ground).coefficients();
}

/// Moves a polynomial to another field.
inline NumberPolynomial moved(const NumberVector& polynomial, const Ground& ground) {
    NumberPolynomial result;
    for (const Number& coefficient : polynomial) {
        result.push_back(read(text(coefficient), ground));
    }
    return result;
}

inline bool same_quotient(const NumberVector& numerator, const NumberVector& denominator,
                          const std::string& expected_numerator,
                          const std::string& expected_denominator) {
    return on_new_ground([&](const Ground& ground) {
        const auto above = read_polynomial(expected_numerator, ground);
        const auto below = read_polynomial(expected_denominator, ground);
        const auto left = product(moved(numerator, ground), below);
        const auto right = product(moved(denominator, ground), above);
        return sum(left, scaled(right, Number(-1))).empty();
    });
}

// ---- methods that are not of Algorithm 4.3 ----

inline NumberMatrix matrix(const std::vector<std::vector<std::string>>& rows) {
    NumberMatrix result;
    for (const auto& row : rows) {
        NumberVector& numbers = result.emplace_back();
        for (const std::string& entry : row) { numbers.push_back(number(entry)); }
    }
    return result;
}

inline PartitionedMethod runge_kutta(const std::vector<std::vector<std::string>>& A,
                                     const std::vector<std::string>& b) {
    const NumberMatrix rows = matrix(A);
    const NumberVector weights = matrix({b}).front();
    return {weights, weights, rows, rows};
}

inline PartitionedMethod kutta_4() {
    return runge_kutta({{"0", "0", "0", "0"},
                        {"1/2", "0", "0", "0"},
                        {"0", "1/2", "0", "0"},
                        {"0", "0", "1", "0"}},
                       {"1/6", "1/3", "1/3", "1/6"});
}

}  // namespace hvi::gen
