// A tableau that someone else made: what its file says, in the file's own digits.
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
    /// Of a decimal that looks like a longer number's first digits. It does when it has 15
    /// significant digits or more; when the file has decimals of 6 or more, so does one that has
    /// about as many digits, or ends at about the same place, as the longest: at most two less.
    /// Others, 0.5 and 0.0625, look exact.
    std::optional<DecimalDigits> rounded;
};

using CoefficientVector = std::vector<Coefficient>;
using CoefficientMatrix = std::vector<CoefficientVector>;  ///< rows

/// A partitioned Runge-Kutta method by its coefficients, letters as in tableau.hpp: 1 to 64 stages,
/// and all vectors and matrices of the size of c.
struct Coefficients {
    std::string name;    ///< as the file has it, or empty
    std::string origin;  ///< `--tableau FILE.json`; one line of ASCII
    CoefficientVector c, b;
    CoefficientMatrix A;
    std::optional<CoefficientVector> b_tilde;  ///< empty where it is b
    std::optional<CoefficientMatrix> A_tilde;  ///< empty where it is A
    std::vector<Parameter> parameters;         ///< each a symbol of a coefficient, no name twice

    [[nodiscard]] std::size_t stages() const { return c.size(); }
};

/// The tableau in a file of at most 32 MiB: the schema `hvi-tableau/1` of `hvi-gen tableau`, of
/// which only what is above is looked at, or any object with `A`, `b`, `c`. A number is a number of
/// JSON, a text, or an object with `exact` and `decimal`, of which `exact` counts unless it is
/// null. Throws InputError with the line of the file.
[[nodiscard]] Coefficients coefficients_from_file(const std::filesystem::path& path);

/// The same for the text of such a file; the source's name is that of the file.
[[nodiscard]] Coefficients coefficients_from_json(const Source& file);

/// The symbols that are parameters, with a value or without, sorted.
[[nodiscard]] std::vector<std::string> parameter_names(const Coefficients& coefficients);

/// As for a method (see method.hpp).
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
