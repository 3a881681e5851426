// Common parts of the texts of methods for people.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/exact/methods/tableau.hpp"
#include "generator/render/layout.hpp"

namespace hvi::gen {

void append(std::string& text, const Lines& lines);

/// Returns a line for each entry, and an empty one.
[[nodiscard]] std::string vector_entries(std::string_view name,
                                         const std::vector<std::string>& vector);
[[nodiscard]] std::string matrix_entries(std::string_view name, const Cells& matrix);

/// Returns the heading of a method: its title, the lines `counts`, its basis and parameters.
[[nodiscard]] std::string heading(const Provenance& provenance,
                                  const std::vector<std::string>& parameters,
                                  const std::string& counts);

}  // namespace hvi::gen
