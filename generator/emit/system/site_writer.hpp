// The forces on the sites of a lattice in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/emit/system/loop_writer.hpp"
#include "generator/lower/sites.hpp"

namespace hvi::gen {

/// Writes the facts about sites that are known when the header is compiled.
void write_site_types(Writer& writer, const Sites& sites);

/// Writes bodies of the functions that src/hvi/detail/loops/sites.hpp requires of a system.
class SiteWriter {
public:
    SiteWriter(const Sites& sites, LoopWriter& loops)
        : sites_(sites), loops_(loops), names_(loops.names()) {}

    void write(Writer& writer, const BodyOfSites& body) {
        std::visit([&](const auto& sites) { write(writer, sites); }, body);
    }

private:
    void write(Writer& writer, const SiteRanges& body);
    void write(Writer& writer, const ValuesOfSites& body);
    void write(Writer& writer, const ForceAtEdge& body);
    void write_edge_term(Writer& writer, const SiteTerm& term);
    [[nodiscard]] NodeNames locals(Writer& writer, const Kernel& kernel);
    [[nodiscard]] std::string place(const SiteAccess& access) const;

    const Sites& sites_;
    LoopWriter& loops_;
    ClassNames& names_;
};

}  // namespace hvi::gen
