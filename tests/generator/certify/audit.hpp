// Tableaux as files, and what is found out about them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/certify/audit.hpp"
#include "generator/render/render.hpp"
#include "tests/generator/exact/exact.hpp"

namespace hvi::gen {

inline Audit audit_of(const std::string& json, int max_order = 8) {
    return audit(coefficients_from_json({"t.json", json}), max_order);
}

/// The text with the one occurrence of a part replaced.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
    const std::size_t at = text.find(part);
    HVI_CHECK(at != std::string::npos && text.find(part, at + 1) == std::string::npos);
    return text.replace(at, part.size(), by);
}

/// `A[1][2]: -1/6` for each wrong entry, with the right value to ten digits where it has no closed
/// form.
inline std::string wrong_entries(const Audit& found) {
    std::string result;
    for (const WrongEntry& entry : found.rebuilt.value().wrong) {
        const auto form = entry.right.closed_form();
        result += (result.empty() ? "" : ", ") + entry.place + ": " +
                  (form ? to_text(*form) : entry.right.decimal(10));
    }
    return result;
}

// ---- tableaux as they are printed elsewhere; typed from the literature ----

/// The classical method of Kutta (1901).
inline const std::string kutta_4 = R"({"c": [0, "1/2", "1/2", 1], "b": ["1/6", "1/3", "1/3", "1/6"],
    "A": [[0, 0, 0, 0], ["1/2", 0, 0, 0], [0, "1/2", 0, 0], [0, 0, 1, 0]]})";

/// Lobatto IIIA-IIIB of order 4: Hairer, Lubich & Wanner, Geometric Numerical Integration, Table
/// II.2.2.
inline const std::string lobatto_3 = R"({"c": [0, "1/2", 1], "b": ["1/6", "2/3", "1/6"],
    "A": [[0, 0, 0], ["5/24", "1/3", "-1/24"], ["1/6", "4/6", "1/6"]],
    "A_tilde": [["1/6", "-1/6", 0], ["1/6", "1/3", 0], ["1/6", "5/6", 0]]})";

/// Gauss of order 6, to 16 places (computed with 60 digits elsewhere).
inline const std::string gauss_3 = R"({
    "c": [0.1127016653792583, 0.5, 0.8872983346207417],
    "b": [0.2777777777777778, 0.4444444444444444, 0.2777777777777778],
    "A": [[0.1388888888888889, -0.0359766675249389, 0.0097894440153083],
          [0.3002631949808646, 0.2222222222222222, -0.0224854172030868],
          [0.2679883337624695, 0.4804211119693833, 0.1388888888888889]]})";

/// The tableau as Python prints it, computed from the formulas in doubles.
inline const std::string gauss_3_of_python = R"({
    "c": [0.1127016653792583, 0.5, 0.8872983346207417],
    "b": [0.2777777777777778, 0.4444444444444444, 0.2777777777777778],
    "A": [[0.1388888888888889, -0.03597666752493894, 0.009789444015308318],
          [0.3002631949808646, 0.2222222222222222, -0.022485417203086805],
          [0.26798833376246944, 0.48042111196938336, 0.1388888888888889]]})";

/// A composition of midpoint rules with the weights g, 1 - 2 g, g for g = 1/(2 - 2^(1/3)), of order
/// 4 (Geometric Numerical Integration, Example II.4.2).
inline const std::string composition_4 = R"({
    "c": [0.67560359597982889, 0.5, 0.32439640402017111],
    "b": [1.3512071919596578, -1.7024143839193153, 1.3512071919596578],
    "A": [[0.67560359597982889, 0, 0],
          [1.3512071919596578, -0.85120719195965763, 0],
          [1.3512071919596578, -1.7024143839193153, 0.67560359597982889]]})";

/// Example 4.5 as the paper prints it.
inline const std::string printed_example_4_5 = R"({"c": [0, 1], "b": ["1/2", "1/2"],
    "A": [[0, 0], ["1/2", "1/2"]], "A_tilde": [[0, 0], ["1/2", "1/2"]]})";

}  // namespace hvi::gen
