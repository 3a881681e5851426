// The pictures of a report.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>

#include "generator/report/report.hpp"

namespace hvi::gen {

/// SVG by the names of their files without an ending, `kepler-1-time`, which are in the order in
/// which they are shown.
using Pictures = std::map<std::string, std::string>;

/// Error against run time and against evaluations, and how energy and invariants depart over time,
/// as far as there is anything to show. Throws as gnuplot_svg() does.
[[nodiscard]] Pictures report_pictures(const SceneReport& scene);

}  // namespace hvi::gen
