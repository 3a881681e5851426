// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/text_parts.hpp"

#include <fmt/format.h>

namespace hvi::gen {

void append(std::string& text, const Lines& lines) {
    for (const std::string& line : lines) text += line + "\n";
}

std::string vector_entries(std::string_view name, const std::vector<std::string>& vector) {
    std::string text;
    for (std::size_t i = 0; i < vector.size(); ++i)
        append(text, wrapped(fmt::format(" {}[{}] = ", name, i + 1), vector[i]));
    return text + "\n";
}

std::string matrix_entries(std::string_view name, const Cells& matrix) {
    std::string text;
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (std::size_t j = 0; j < matrix[i].size(); ++j)
            append(text, wrapped(fmt::format(" {}[{},{}] = ", name, i + 1, j + 1), matrix[i][j]));
    return text + "\n";
}

std::string heading(const Provenance& provenance, const std::vector<std::string>& parameters,
                    const std::string& counts) {
    std::string text;
    append(text, wrapped("", provenance.title()));
    text += "\n" + counts;
    std::string basis;
    for (const Expression& function : provenance.basis)
        basis += (basis.empty() ? "" : ", ") + to_text(function);
    append(text, wrapped("basis       ", basis));
    if (!parameters.empty())
        append(text, wrapped("parameters  ", fmt::format("{}", fmt::join(parameters, ", "))));
    return text + "\n";
}

}  // namespace hvi::gen
