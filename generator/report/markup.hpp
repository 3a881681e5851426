// Texts and pictures as parts of a page.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace hvi::gen {

/// A text in HTML, in which numbers with an exponent show a power of ten.
[[nodiscard]] std::string escaped(const std::string& text);

/// A text in HTML as it is, for attributes in double quotes and for titles, which have no markup.
[[nodiscard]] std::string attribute(const std::string& text);

/// A number of three digits, with a power of ten; a dash for what is no finite number.
[[nodiscard]] std::string number_markup(double value);

/// A table of a class from its caption to where its rows begin; the heads of columns are HTML. It
/// ends with `end_of_table`.
[[nodiscard]] std::string table_of(const std::string& kind, const std::string& caption,
                                   const std::vector<std::string>& heads);
inline constexpr const char* end_of_table = "</tbody></table></div>\n";

/// A row for a group of rows, above them.
[[nodiscard]] std::string group_row(const std::string& text, std::size_t columns);

/// An SVG of gnuplot from its first element on, as what stands before belongs to a file of its own;
/// with this title. Its ids begin with `prefix`: the ids of all pictures of a page must differ.
[[nodiscard]] std::string inlined(const std::string& svg, const std::string& title,
                                  const std::string& prefix);

}  // namespace hvi::gen
