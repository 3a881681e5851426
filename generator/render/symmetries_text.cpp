// Symmetries for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/render/named_lines.hpp"
#include "generator/render/symmetries.hpp"

namespace hvi::gen {

namespace {

std::string plural(std::size_t count, std::string_view singular, std::string_view plural) {
    return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

/// Returns `x' = -y, y' = x`.
std::string generator_text(const SceneSymmetries& found, const AffineSymmetry& symmetry) {
    std::string text;
    for (std::size_t i = 0; i < found.coordinates.size(); ++i) {
        const std::string component = to_text(symmetry.generator[i]);
        if (component == "0") continue;
        text +=
            fmt::format("{}{}' = {}", text.empty() ? "" : ", ", found.coordinates[i], component);
    }
    return text;
}

std::string count_text(const AffineSymmetries& affine) {
    const std::size_t n = affine.basis.size();
    if (affine.doubt.empty())
        return n == 0 ? "none, of affine transformations of the coordinates"
                      : fmt::format("{} of affine transformations, and these are all",
                                    plural(n, "generator", "generators"));
    return n == 0 ? fmt::format("none found ({})", affine.doubt)
                  : fmt::format("at least {} ({})", n, affine.doubt);
}

/// Returns `{J1, J2} = J3, ...`.
std::string brackets_text(const std::vector<StructureConstant>& constants) {
    std::string text;
    const StructureConstant* before = nullptr;
    for (const StructureConstant& constant : constants) {
        const bool same = before != nullptr && before->i == constant.i && before->j == constant.j;
        const Expression name = Expression::symbol(fmt::format("J{}", constant.k + 1));
        std::string term = to_text(Expression::product({constant.value, name}));
        if (constant.value == Expression::integer(1)) term = name.name;
        if (constant.value == Expression::integer(-1)) term = "-" + name.name;
        if (same)
            text += (term.front() == '-' ? "" : "+") + term;
        else
            text += fmt::format("{}{{J{}, J{}}} = {}", before == nullptr ? "" : ", ",
                                constant.i + 1, constant.j + 1, term);
        before = &constant;
    }
    return text.empty() ? "all brackets vanish" : text;
}

void write_algebra(NamedLines& lines, const AffineSymmetries& affine) {
    constexpr std::size_t most_shown = 24;  // brackets
    if (affine.basis.empty()) return;
    if (!affine.algebra) {
        lines.line("algebra", "not looked at");
        return;
    }
    const SymmetryAlgebra& algebra = *affine.algebra;
    if (!algebra.constants) {
        lines.line("algebra", algebra.name.empty() ? "none of the usual ones" : algebra.name);
        return;
    }
    const std::size_t count = algebra.constants->size();
    const std::string name = algebra.name.empty() ? "" : algebra.name + ": ";
    lines.line("algebra",
               name +
                   (count > most_shown
                        ? fmt::format("{} structure constants, which --format json prints", count)
                        : brackets_text(*algebra.constants)));
}

void write_regularity(NamedLines& lines, const SceneSymmetries& found) {
    const bool is_lagrangian = found.side == Side::lagrangian;
    const char* const matrix = is_lagrangian ? "d2L/dv2" : "d2H/dp2";
    if (!found.rank) {
        lines.line("regular", fmt::format("not known: the rank of {} is not decided", matrix));
        return;
    }
    const std::string rank =
        fmt::format("{} has the rank {} of {}", matrix, *found.rank, found.degrees_of_freedom);
    lines.line("regular", (found.is_regular() ? "yes: " : "no: ") + rank);
    if (found.is_regular() || is_lagrangian) return;
    lines.line("", "degenerate (Example 1.1 of Leok & Zhang): q' = dH/dp has no");
    lines.line("", "solution for p, and no Lagrangian belongs to H");
    lines.line("steps", "by methods with as many nodes as functions, not by the");
    lines.line("", "general form, which has more nodes");
}

std::string verdict(const ConservedQuantity& invariant) {
    switch (invariant.finding.conserved) {
    case Vanishing::proved: return "conserved";
    case Vanishing::refuted:
        return (invariant.is_approximate ? "approximate: " : "") + not_zero(invariant);
    case Vanishing::unknown: break;
    }
    return "not known to be conserved";
}

}  // namespace

std::string render_text(const SceneSymmetries& found) {
    NamedLines lines;
    lines.title(found.name);
    lines.blank();
    lines.line("symmetries", count_text(found.affine));
    for (std::size_t i = 0; i < found.affine.basis.size(); ++i) {
        const AffineSymmetry& symmetry = found.affine.basis[i];
        lines.line(fmt::format("  J{}", i + 1), to_text(symmetry.momentum_map));
        const std::string by = "by " + generator_text(found, symmetry);
        if (by.size() <= NamedLines::columns) lines.line("", by);
    }
    write_algebra(lines, found.affine);
    lines.blank();
    write_regularity(lines, found);
    if (!found.invariants.empty()) lines.blank();
    for (const ConservedQuantity& invariant : found.invariants)
        lines.line(&invariant == &found.invariants.front() ? "invariants" : "",
                   invariant.name + ": " + verdict(invariant));
    if (!found.fields.empty()) lines.blank();
    for (const ConservedQuantity& field : found.fields)
        lines.line(
            &field == &found.fields.front() ? "as it says" : "",
            fmt::format("{}, with {}: {}", field.name, to_text(field.expression), verdict(field)));
    return lines.text();
}

}  // namespace hvi::gen
