// Events of a run as points in a plane: a Poincare section, where they are passages through a
// surface.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "generator/draw/trajectory.hpp"

namespace hvi::gen {

struct SectionPicture {
    std::string title;
    /// A row of names, and rows with the name of an event, its number, and numbers.
    std::filesystem::path table;
    std::int64_t rows = 0;            ///< of numbers; of many some are shown, evenly spaced
    std::vector<std::string> events;  ///< names of those that are shown, at least one
    TableColumn x, y;
};

/// Draws SVG, in which events of one name have one colour. Throws as gnuplot_svg() does.
/// Precondition: the table has a row.
[[nodiscard]] std::string draw(const SectionPicture& picture);

}  // namespace hvi::gen
