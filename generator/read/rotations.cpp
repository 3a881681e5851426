// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/rotations.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace hvi::gen {

namespace {

/// Adds an index to a name: `R` with 1,2 is R[1,2], and `R[3]` is R[3,1,2].
std::string with_index(const std::string& name, const std::string& index) {
    return name.back() == ']' ? fmt::format("{},{}]", name.substr(0, name.size() - 1), index)
                              : fmt::format("{}[{}]", name, index);
}

/// NOTE: axes often lie along a coordinate, and terms with their zeros would be written to headers.
bool is_zero(const Expression& x) {
    return x.kind == Expression::Kind::number && x.numerator == "0";
}

Expression square(const Expression& x) { return Expression::power(x, Expression::integer(2)); }

Expression times(const Expression& a, const Expression& b) {
    return is_zero(a) || is_zero(b) ? Expression::integer(0) : Expression::product({a, b});
}

Expression sum_of(std::vector<Expression> terms) {
    std::erase_if(terms, is_zero);
    return Expression::sum(std::move(terms));
}

Expression negative(const Expression& x) { return is_zero(x) ? x : Expression::negation(x); }

Expression sum_of_squares(const std::vector<Expression>& parts) {
    std::vector<Expression> terms;
    for (const Expression& part : parts) terms.push_back(is_zero(part) ? part : square(part));
    return sum_of(std::move(terms));
}

/// Returns the entries of diagonal + scale a a^T + hat b.
std::vector<Expression> matrix(const Expression& diagonal, const std::vector<Expression>& a,
                               const Expression& scale, const std::vector<Expression>& b) {
    std::vector<Expression> entries;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            std::vector<Expression> terms{times(scale, times(a[i], a[j]))};
            if (i == j) {
                terms.push_back(diagonal);
            } else {
                const Expression& third = b[3 - i - j];
                const bool is_negative = j == (i + 1) % 3;
                terms.push_back(is_negative ? negative(third) : third);
            }
            entries.push_back(sum_of(std::move(terms)));
        }
    }
    return entries;
}

}  // namespace

std::vector<std::string> entries_of(const std::string& rotation) {
    std::vector<std::string> names;
    for (int i = 1; i <= 3; ++i)
        for (int j = 1; j <= 3; ++j)
            names.push_back(with_index(rotation, fmt::format("{},{}", i, j)));
    return names;
}

std::vector<std::string> components_of(const std::string& momentum) {
    std::vector<std::string> names;
    for (int i = 1; i <= 3; ++i) names.push_back(with_index(momentum, std::to_string(i)));
    return names;
}

std::vector<Expression> identity_rotation() {
    std::vector<Expression> entries(9, Expression::integer(0));
    for (std::size_t i = 0; i < 3; ++i) entries[4 * i] = Expression::integer(1);
    return entries;
}

/// Rodrigues: cos + (1 - cos) n n^T + sin hat n. NOTE: 1 - cos is 2 sin^2 of half of the angle,
/// which has all digits of a small one.
std::vector<Expression> turn_about(const std::vector<Expression>& axis, const Expression& angle) {
    const Expression length_squared = sum_of_squares(axis);
    const Expression half = times(Expression::rational("1", "2"), angle);
    const Expression rest = times(Expression::integer(2), square(Expression::call("sin", {half})));
    const Expression cosine = Expression::sum({Expression::integer(1), Expression::negation(rest)});
    const Expression sine =
        times(Expression::call("sin", {angle}),
              Expression::reciprocal(Expression::call("sqrt", {length_squared})));
    std::vector<Expression> turn;
    for (const Expression& part : axis) turn.push_back(times(sine, part));
    return matrix(cosine, axis, times(rest, Expression::reciprocal(length_squared)), turn);
}

/// 1 - 2 (x^2 + y^2 + z^2) + 2 v v^T + 2 w hat v of a unit quaternion.
std::vector<Expression> turn_of_quaternion(const std::vector<Expression>& wxyz) {
    const std::vector<Expression> v(wxyz.begin() + 1, wxyz.end());
    const Expression two =
        times(Expression::integer(2), Expression::reciprocal(sum_of_squares(wxyz)));
    const Expression diagonal =
        sum_of({Expression::integer(1), negative(times(two, sum_of_squares(v)))});
    std::vector<Expression> turn;
    for (const Expression& part : v) turn.push_back(times(times(two, wxyz.front()), part));
    return matrix(diagonal, v, two, turn);
}

}  // namespace hvi::gen
