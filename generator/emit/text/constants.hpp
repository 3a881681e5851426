// Exact numbers in a header, in the formats that it computes in.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/text/text.hpp"
#include "generator/exact/numbers/formats.hpp"

namespace hvi::gen {

/// A coefficient in a header: its value in each format, and exactly.
struct Constant {
    std::string name;  ///< `m_12`, in the comment
    Rounded value;
    std::string exact;
};

/// Returns the nearest numbers, small ones too, and 0 where the value is within 2^-300 of it: for
/// coefficients that need not be good to their last bit.
[[nodiscard]] Rounded rough_value(const Number& value);

/// Returns a constant that is rounded on its own. NOTE: symmetry and orthogonality make zeros that
/// enclosures do not prove. A value below 2^-300 can be one.
[[nodiscard]] Constant constant(std::string name, const Number& value);

/// Write `static constexpr Scalar NAME[n] = {...};` with the exact value beside or above each
/// entry: one literal where it is the same in all formats, else a call of rounded(). They throw
/// MathError where double, or a longer format, has no such number.
void table(Writer& writer, std::string_view name, const std::vector<Constant>& row);
void table(Writer& writer, std::string_view name, const std::vector<std::vector<Constant>>& rows);

/// Writes `static constexpr Scalar NAME[n][k] = {...};` with the nearest doubles alone, for entries
/// that need not be good to the last bit and have long exact values.
void table_of_doubles(Writer& writer, std::string_view name,
                      const std::vector<std::vector<Rounded>>& rows);

/// Returns the number as the initial value of a Scalar in C++: a literal, or a call of rounded().
/// Throws MathError as table() does.
[[nodiscard]] std::string initializer(const Constant& constant);

/// Returns the initial value for a place where rounded() is not declared.
[[nodiscard]] std::string qualified_initializer(const Constant& constant);

/// Return the text of tables, after the declaration of rounded() where they call it, or in any
/// case.
[[nodiscard]] std::string with_rounding(const std::string& tables);
[[nodiscard]] std::string with_rounding_declared(const std::string& text);
[[nodiscard]] bool are_rounded(std::string_view tables);

/// Writes a static_assert against float for each of the constants that float cannot hold.
void refuse_float(Writer& writer, const std::vector<Constant>& constants);

}  // namespace hvi::gen
