// The terms of stage equations: names of values in stages, and sums over stages.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/expr/expression.hpp"

namespace hvi::gen {

struct Equation {
    std::string left;
    Expression right;
};

/// An equation for an unknown in its left side, or in both.
struct ImplicitEquation {
    Expression left, right;
};

[[nodiscard]] std::set<std::string> symbols_in(const Expression& expression);
[[nodiscard]] bool occurs_in(const std::string& symbol, const std::vector<Expression>& expressions);

/// The names of the values in one stage, by the names of variables.
using StageNames = std::map<std::string, std::string>;

/// Returns names for each stage: Q_1 for q, but q_1 where Q or Q_1 is `taken`, and q_stage_1 where
/// q_1 is taken too.
[[nodiscard]] std::vector<StageNames> stage_names(const std::vector<std::string>& varying,
                                                  const std::set<std::string>& taken,
                                                  std::size_t stages);

/// A row of coefficients: the numbers and their written forms, which are empty for zero.
struct Row {
    NumberVector numbers;
    std::vector<std::optional<Expression>> written;
};

/// Sums over the stages with the coefficients of a method. Terms with the coefficient 0 are left
/// out; a coefficient without a closed form is a decimal of 20 digits.
class StageTerms {
public:
    explicit StageTerms(std::vector<StageNames> names) : names_(std::move(names)) {}

    /// Returns the name in a stage, whose index is 0-based.
    [[nodiscard]] const std::string& name(const std::string& variable, std::size_t stage) const {
        return names_[stage].at(variable);
    }
    [[nodiscard]] Expression in_stage(const Expression& expression, std::size_t stage) const {
        return renamed(expression, names_[stage]);
    }

    [[nodiscard]] Row written(const NumberVector& row);

    /// Returns sum_j row_j value(Q^j, ...).
    [[nodiscard]] Expression sum(const Expression& value, const Row& row) {
        return Expression::sum(terms(value, row));
    }
    /// Returns factor * expression.
    [[nodiscard]] Expression multiple(const Number& factor, const Expression& expression);

    /// Returns start +- h sum_j row_j derivative(Q^j, ...); the sign is a minus where `falls`.
    [[nodiscard]] Expression moved(const Expression& start, const Expression& derivative,
                                   const Row& row, bool falls);

    /// Returns T_i = t + c_i h.
    [[nodiscard]] Equation time(std::size_t stage, const Number& node);

    /// Whether each coefficient so far has a closed form.
    [[nodiscard]] bool is_exact() const { return is_exact_; }

private:
    [[nodiscard]] Expression written(const Number& number);
    [[nodiscard]] Expression term(const Number& coefficient, const Expression& coefficient_form,
                                  const Expression& derivative);
    [[nodiscard]] std::vector<Expression> terms(const Expression& derivative, const Row& row);

    std::vector<StageNames> names_;
    bool is_exact_ = true;
};

}  // namespace hvi::gen
