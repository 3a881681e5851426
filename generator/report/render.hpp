// A report as JSON, as tables, and as a page.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/report/pictures.hpp"

namespace hvi::gen {

/// Schema hvi-report/1 of CONTRACT.md. What is no finite number is null.
[[nodiscard]] std::string report_json(const Report& report);

/// A row for each point.
[[nodiscard]] std::string report_csv(const Report& report);

/// A row for each scene and accuracy: the fastest method, the fastest of other libraries, and how
/// many times faster it is.
[[nodiscard]] std::string times_csv(const Report& report);

/// A row for each case at the edges.
[[nodiscard]] std::string edges_csv(const Report& report);

/// One page that needs nothing beside it. Precondition: the pictures are those of the report, or
/// there are none.
[[nodiscard]] std::string report_html(const Report& report, const Pictures& pictures);

}  // namespace hvi::gen
