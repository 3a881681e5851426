// The basis in which the equations of Newton's method decouple.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/implicit_parts.hpp"

namespace hvi::gen {

namespace {

/// Returns a list of doubles. NOTE: doubles do in every format: they decide how fast Newton's
/// method is, not where it ends.
std::string list(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) {
        text += fmt::format("{}Scalar({})", text.empty() ? "" : ", ", value);
    }
    return text;
}

void array(Writer& writer, std::string_view name, const std::vector<double>& values) {
    // NOTE: no array is empty in C++.
    writer.line("static constexpr Scalar {}[{}] = {{{}}};", name,
                std::max<std::size_t>(values.size(), 1), list(values));
}

void matrix(Writer& writer, std::string_view name, const std::vector<std::vector<double>>& rows) {
    writer.line("static constexpr Scalar {0}[{1}][{1}] = {{", name, rows.size());
    for (const std::vector<double>& row : rows) { writer.line("    {{{}}},", list(row)); }
    writer.line("}};");
}

}  // namespace

std::string modes_text(const std::optional<RealModes>& found, std::string_view name,
                       std::string_view C, std::size_t indent) {
    Writer writer(indent);
    if (!found) {
        return writer.open("struct {} {{", name)
            .line("static constexpr bool exist = false;")
            .close("};")
            .str();
    }
    const RealModes& modes = *found;
    writer.comment(fmt::format("The real eigenvalues of C_ij = {}, then pairs of complex ones, and "
                               "the basis in which C is diagonal but for the pairs. Approximate.",
                               C),
                   "/// ");
    writer.open("struct {} {{", name).line("static constexpr bool exist = true;");
    writer.line("static constexpr std::size_t real_ones = {};", modes.real_ones);
    writer.line("static constexpr std::size_t pairs = {};", modes.imaginary_parts.size());
    array(writer, "real_parts", modes.real_parts);
    array(writer, "imaginary_parts", modes.imaginary_parts);
    matrix(writer, "to", modes.to);
    matrix(writer, "from", modes.from);
    return writer.close("};").str();
}

}  // namespace hvi::gen
