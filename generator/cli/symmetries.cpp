// `hvi-gen symmetries`: affine symmetries, their momentum maps, and conserved quantities.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/symmetries.hpp"

#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

namespace {

/// Throws MathError for the first claimed invariant, and for the first claimed symmetry, that is
/// none.
void check_said(const SceneSymmetries& found) {
    for (const ConservedQuantity& invariant : found.invariants)
        if (invariant.finding.conserved == Vanishing::refuted && !invariant.is_approximate)
            throw MathError("the invariant `" + invariant.name + "`: " + not_zero(invariant),
                            invariant.place, help_for_not_zero);
    for (const ConservedQuantity& field : found.fields)
        if (field.finding.conserved == Vanishing::refuted)
            throw MathError(
                "`" + field.name + "` is no symmetry: the bracket of its momentum map " +
                    to_text(field.expression) + " with H is " + to_text(field.finding.bracket),
                field.place);
}

}  // namespace

void run(const SymmetriesOptions& options) {
    const SceneSymmetries found =
        find_symmetries(read_scene_alone(options.parameters, options.system), options.system.sums);
    check_said(found);
    const bool as_json = options.format == SymmetriesOptions::Format::json;
    write_result(options.output, as_json ? render_json(found) : render_text(found));
}

}  // namespace hvi::gen
