// The parts of the page of a report.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/report/pictures.hpp"
#include "generator/report/report.hpp"

namespace hvi::gen {

/// The title of the page: which methods or scenes it is about.
[[nodiscard]] std::string report_title(const Report& report);

/// Sentences on which method is fastest and whether the edges are as expected, and a table: of each
/// scene the fastest method to each error.
[[nodiscard]] std::string summary_html(const Report& report);

/// Links to all sections below.
[[nodiscard]] std::string contents_html(const Report& report);

/// The id of the section about the k-th scene, or about the k-th chapter of edges.
[[nodiscard]] std::string id_of_scene(std::size_t k);
[[nodiscard]] std::string id_of_chapter(std::size_t k);

/// The section about edges; empty where there is none.
[[nodiscard]] std::string edges_html(const Report& report, const Pictures& pictures);

/// All pictures of a section, beside each other where there is room. The ids in them begin with
/// that of the section.
[[nodiscard]] std::string pictures_html(const std::vector<Picture>& pictures,
                                        const std::string& section);

}  // namespace hvi::gen
