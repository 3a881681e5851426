// Whole numbers that depend on sizes and indices: indices of elements, and bounds of sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// A constant plus a sum of coefficients times names. No coefficient is 0.
struct AffineForm {
    long constant = 0;
    std::map<std::string, long> coefficients = {};

    [[nodiscard]] static AffineForm of(const std::string& name) { return {0, {{name, 1}}}; }
    [[nodiscard]] long coefficient(const std::string& name) const;
    [[nodiscard]] bool is_number() const { return coefficients.empty(); }
    /// Returns the value. Precondition: `values` has all names.
    [[nodiscard]] long at(const std::map<std::string, long>& values) const;

    friend bool operator==(const AffineForm&, const AffineForm&) = default;
};

[[nodiscard]] AffineForm operator+(const AffineForm& a, const AffineForm& b);
[[nodiscard]] AffineForm operator-(const AffineForm& a, const AffineForm& b);
[[nodiscard]] AffineForm operator*(long factor, const AffineForm& a);

/// Substitutes a form for a name.
[[nodiscard]] AffineForm replaced(const AffineForm& form, const std::string& name,
                                  const AffineForm& by);

/// Returns an expression as such a form; empty for others: i*j, i/2, mod(i, 2), or numbers above
/// 10^8.
[[nodiscard]] std::optional<AffineForm> affine_form(const Expression& expression);

/// Returns the form as an expression: added terms come before subtracted ones, as in N-k+1.
[[nodiscard]] Expression as_expression(const AffineForm& form);

/// Returns the form as people write it: `N - 1`, `2*i + j`.
[[nodiscard]] std::string to_text(const AffineForm& form);

}  // namespace hvi::gen
