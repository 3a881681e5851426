// Whole numbers that depend on sizes and indices: what stands in an index, and bounds of sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// constant + the sum of coefficients times names, of which none is 0.
struct AffineForm {
    long constant = 0;
    std::map<std::string, long> coefficients = {};

    [[nodiscard]] static AffineForm of(const std::string& name) { return {0, {{name, 1}}}; }
    [[nodiscard]] long coefficient(const std::string& name) const;
    [[nodiscard]] bool is_number() const { return coefficients.empty(); }
    /// Precondition: `values` has all names.
    [[nodiscard]] long at(const std::map<std::string, long>& values) const;

    friend bool operator==(const AffineForm&, const AffineForm&) = default;
};

[[nodiscard]] AffineForm operator+(const AffineForm& a, const AffineForm& b);
[[nodiscard]] AffineForm operator-(const AffineForm& a, const AffineForm& b);
[[nodiscard]] AffineForm operator*(long factor, const AffineForm& a);

/// The form with another in the place of a name.
[[nodiscard]] AffineForm replaced(const AffineForm& form, const std::string& name,
                                  const AffineForm& by);

/// What is written, as such a form; empty where it is none: i*j, i/2, mod(i, 2), or above 10^8.
[[nodiscard]] std::optional<AffineForm> affine_form(const Expression& expression);

/// The form as an expression: what is added comes before what is subtracted, as in N-k+1.
[[nodiscard]] Expression as_expression(const AffineForm& form);

/// `N - 1`, `2*i + j`, as people write it.
[[nodiscard]] std::string to_text(const AffineForm& form);

}  // namespace hvi::gen
