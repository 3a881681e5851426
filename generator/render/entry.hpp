// Common parts of the formats: an entry of a tableau in its three forms, and the order of all
// entries.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

/// A number in its output forms.
struct Entry {
    std::optional<Expression> exact;     ///< empty when there is no closed form
    std::optional<std::string> decimal;  ///< empty with a free parameter
    std::optional<std::string> hex;      ///< the nearest double as `0x1.8p+0`; empty as `decimal`

    /// Returns the exact form in our notation.
    [[nodiscard]] std::optional<std::string> exact_text() const;

    /// Returns the exact form, or else the decimal one.
    [[nodiscard]] std::string best_text() const;
};

/// Makes an entry. Precondition: digits >= 1.
[[nodiscard]] Entry make_entry(const Number& number, int digits);

/// A vector or a matrix of a method under its name in output.
struct Part {
    std::string_view name;
    bool is_vector;
    NumberMatrix rows;  ///< for a vector, one number in each row
};

/// Returns all vectors and matrices: c, b, c_tilde, A, A_tilde, and Galerkin's M, M_inverse, B,
/// A_psi.
[[nodiscard]] std::vector<Part> parts(const Tableau& tableau);

/// Returns the parts of the general form: c, b, B, Psi, A_psi and gram.
[[nodiscard]] std::vector<Part> parts(const GalerkinRule& rule);

/// Returns the parts of its Nystrom method: c, A_bar, b_bar and b.
[[nodiscard]] std::vector<Part> nystrom_parts(const GalerkinRule& rule);

/// Returns both, with shared parts once.
[[nodiscard]] std::vector<Part> all_parts(const GalerkinRule& rule);

/// Calls `visit(part, row, column, entry)` for every entry, rows and columns counted from 1.
template <class Visitor>
void for_each_entry(const std::vector<Part>& parts, int digits, Visitor&& visit) {
    for (const Part& part : parts)
        for (std::size_t i = 0; i < part.rows.size(); ++i)
            for (std::size_t j = 0; j < part.rows[i].size(); ++j)
                visit(part, i + 1, j + 1, make_entry(part.rows[i][j], digits));
}

}  // namespace hvi::gen
