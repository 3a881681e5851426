// The pictures of a report.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/report/report.hpp"

namespace hvi::gen {

struct Picture {
    std::string name;   ///< of its file, without an ending: `kepler-1-time`
    std::string title;  ///< of which no other picture of the report has the same
    std::string svg;
};

/// All pictures of a report, in the order in which they are shown.
struct Pictures {
    std::vector<std::vector<Picture>> of_scenes;  ///< of each
    std::vector<std::vector<Picture>> of_edges;   ///< of each chapter
};

/// Draws for each scene error against run time and against evaluations, and how energy and
/// invariants depart over time; and the pictures of the edges, `edges-stiff-1`; as far as there is
/// anything to show. Throws as gnuplot_svg() does.
[[nodiscard]] Pictures report_pictures(const Report& report);

}  // namespace hvi::gen
