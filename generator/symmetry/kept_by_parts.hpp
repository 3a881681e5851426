// Quantities that the flows of parts of H keep.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/hamiltonian/conserved.hpp"
#include "generator/ir/part.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

/// Whether the bracket of a quantity with each part of H vanishes. The flow of a part keeps the
/// quantity exactly if it does.
using BracketsWithParts = std::vector<Vanishing>;

/// Parts of H beside quantities.
struct KeptByParts {
    std::vector<std::string> parts;           ///< their names
    std::vector<BracketsWithParts> brackets;  ///< of each quantity
};

/// Whether the flow of each part keeps the quantity, so that every splitting does.
[[nodiscard]] bool is_kept_by_all(const BracketsWithParts& brackets);

/// Returns the parts whose brackets are known to be so, between commas: `A, C`.
[[nodiscard]] std::string names_of_parts(const KeptByParts& parts,
                                         const BracketsWithParts& brackets, Vanishing known);

/// Decides by exact algebra, where bodies turn with the bracket of Lie and Poisson. Parameters have
/// the values in H, and are any numbers where they have none. What takes longer than about a second
/// is unknown, as is all about a part that is too long to be written. Precondition: the parts are
/// those of H.
[[nodiscard]] KeptByParts kept_by_parts(const HamiltonianParts& parts, const Hamiltonian& H,
                                        const std::vector<Quantity>& quantities);

/// Decides for the quantities of a scene, in the order of quantities_of(), and for H behind them.
/// NOTE: the brackets of an H that depends on the time do not tell whether it is conserved.
[[nodiscard]] KeptByParts kept_by_parts(const HamiltonianParts& parts, const WrittenOutScene& scene,
                                        const SceneSymmetries& found);

}  // namespace hvi::gen
