// The equations of a step with indices for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/render/equations.hpp"
#include "generator/render/equations_page.hpp"
#include "generator/render/loop_equations.hpp"

namespace hvi::gen {

namespace {

/// Writes a derivative. Terms that are not everywhere begin a line, and end with their ranges.
void write_slope(EquationsPage& page, const std::string& name, const ElementSlope& slope) {
    std::string head = " " + name + " = ";
    for (const PlacedTerm& term : placed_terms(slope, false)) {
        std::vector<std::string> ranges;
        for (const Loop& range : term.where) ranges.push_back(to_text(range));
        page.line(head, ranges.empty()
                            ? term.text
                            : fmt::format("{}  for {}", term.text, fmt::join(ranges, ", ")));
        head.assign(head.size(), ' ');
    }
}

void write_stages(EquationsPage& page, const LoopEquations& step) {
    const StageEquations& equations = step.stages;
    page.remark(fmt::format("{} {}{}:\n\n", equations.is_explicit ? "for all" : "stages for all",
                            fmt::join(step.gradient.indices, ", "),
                            equations.is_explicit ? "" : ", to be solved together"));
    for (const Equation& stage : equations.stages) page.equation(stage.left, stage.right);
    if (!equations.is_explicit) page.remark("\nand with them:\n\n");
    for (const Equation& update : equations.update) page.equation(update.left + "'", update.right);
    if (equations.is_explicit)
        page.remark("\nEach line needs those above it only, for all indices.\n");
    if (!equations.is_exact) page.remark(EquationsPage::inexact);
}

}  // namespace

std::string render_text(const LoopEquations& step) {
    EquationsPage page;
    page.title(step);
    page.remark("\n");
    page.fact("hamiltonian", to_text(step.hamiltonian));
    page.names("coordinates", texts(step.coordinates));
    page.names("momenta", texts(step.momenta));
    page.parameters(step);
    write_stages(page, step);
    page.remark("\nderivatives of H, of which the stages have those at their values:\n\n");
    for (const auto& [family, slope] : named_slopes(step))
        write_slope(page, slope_name(family, step.gradient.indices), slope);
    return page.text();
}

}  // namespace hvi::gen
