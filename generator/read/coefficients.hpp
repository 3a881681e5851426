// A tableau from another source: its coefficients in the digits of its file.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/read/decimal.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// One number of a tableau.
struct Coefficient {
    Expression value;                      ///< exactly as it is written
    std::shared_ptr<const Source> source;  ///< the text that was read
    /// The digits of a decimal that looks rounded; empty for one that looks exact, such as 0.5 and
    /// 0.0625. A decimal with 15 significant digits or more looks rounded. Where the file has
    /// decimals of 6 digits or more, one looks rounded too if it has as many digits as the longest
    /// of them, or ends at the last place of the file, give or take two.
    std::optional<DecimalDigits> rounded;
};

using CoefficientVector = std::vector<Coefficient>;
using CoefficientMatrix = std::vector<CoefficientVector>;  ///< rows

/// A partitioned Runge-Kutta method given by its coefficients, with the letters of tableau.hpp. It
/// has 1 to 64 stages, and all vectors and matrices have the size of c.
struct Coefficients {
    std::string name;    ///< the key `name`, or empty
    std::string origin;  ///< `--tableau FILE.json`; one line of ASCII
    CoefficientVector c, b;
    CoefficientMatrix A;
    std::optional<CoefficientVector> b_tilde;  ///< empty where it is b
    std::optional<CoefficientMatrix> A_tilde;  ///< empty where it is A
    std::vector<Parameter> parameters;         ///< each a symbol of a coefficient, no name twice

    [[nodiscard]] std::size_t stages() const { return c.size(); }
};

/// Reads the tableau in a file of at most 32 MiB: the schema `hvi-tableau/1` of `hvi-gen tableau`,
/// or any object with `A`, `b`, `c`. Other keys of the schema are ignored. A number is a JSON
/// number, a text, or an object with `exact` and `decimal`, in which `exact` counts unless it is
/// null. Throws InputError with the line of the file.
[[nodiscard]] Coefficients coefficients_from_file(const std::filesystem::path& path);

/// Reads the text of such a file; the source's name is the file's name.
[[nodiscard]] Coefficients coefficients_from_json(const Source& file);

/// Returns the symbols that are parameters, with a value or without, sorted.
[[nodiscard]] std::vector<std::string> parameter_names(const Coefficients& coefficients);

/// Gives a parameter its value as set_parameter() of a method does (see method.hpp).
void set_parameter(Coefficients& coefficients, Parameter parameter);

/// Calls `visit` for each coefficient.
template <class Tableau, class Visitor>
void for_each_coefficient(Tableau& tableau, Visitor&& visit) {
    const auto vector = [&](auto& entries) {
        for (auto& entry : entries) { visit(entry); }
    };
    vector(tableau.c);
    vector(tableau.b);
    if (tableau.b_tilde) { vector(*tableau.b_tilde); }
    for (auto& row : tableau.A) { vector(row); }
    if (!tableau.A_tilde) { return; }
    for (auto& row : *tableau.A_tilde) { vector(row); }
}

}  // namespace hvi::gen
