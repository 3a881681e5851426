// The symmetries of a scene, and the quantities that it claims to be conserved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/expr/side.hpp"
#include "generator/hamiltonian/affine_symmetries.hpp"
#include "generator/hamiltonian/conserved.hpp"
#include "generator/read/unrolling.hpp"

namespace hvi::gen {

/// A function of the scene's variables that is, or ought to be, conserved.
struct ConservedQuantity {
    enum class Kind { momentum_map, invariant, field, energy };

    Kind kind = Kind::invariant;
    std::string name;             ///< `J1`, the scene's name for it, or `energy`
    Expression expression;        ///< in the scene's variables
    QuantityFinding finding;      ///< findings for it as a function of q and p
    Place place;                  ///< the place of an invariant, or of a field's name
    bool is_said = false;         ///< a momentum map that invariants of the scene tell already
    bool is_approximate = false;  ///< an invariant that need not be conserved
};

/// Returns `{C, H} = p^3-p is not zero as a function of q and p`. NOTE: on one energy it still may
/// be zero. Precondition: it is refuted that the bracket vanishes.
[[nodiscard]] std::string not_zero(const ConservedQuantity& quantity);
constexpr const char* help_for_not_zero =
    "where that is meant so, write {value = \"...\", approximate = true}";

/// The symmetries of a scene.
struct SceneSymmetries {
    std::string name;  ///< the scene's name, or its words on the command line
    Side side = Side::hamiltonian;
    std::vector<std::string>
        coordinates;  ///< or families of them, `x[i]`; entries of rotations too
    std::size_t degrees_of_freedom = 0;
    std::size_t rotations = 0;
    std::optional<std::size_t> rank;  ///< rank of d2H/dp2 or d2L/dv2, if known
    bool depends_on_time = false;
    AffineSymmetries affine;
    std::vector<ConservedQuantity> momentum_maps;  ///< in the order of the affine symmetries
    std::vector<ConservedQuantity> invariants;     ///< in the order of the scene
    std::vector<ConservedQuantity> fields;         ///< momentum maps (5.4) of [symmetries]
    std::optional<ConservedQuantity> energy;       ///< where more is known than that it is H

    [[nodiscard]] bool is_regular() const { return rank == degrees_of_freedom; }
};

/// Returns momentum maps, invariants and those of [symmetries].
[[nodiscard]] std::vector<const ConservedQuantity*> quantities_of(const SceneSymmetries& found);

/// The most degrees of freedom for which symmetries of a scene without loops are sought.
constexpr std::size_t most_degrees_of_symmetries = 64;

/// Finds symmetries by exact algebra, for the values of the scene's parameters. Where sums stay
/// loops, it finds symmetries of whole families. Throws as symmetries_of() and
/// symmetries_of_families() do.
[[nodiscard]] SceneSymmetries find_symmetries(const Scene& scene, const UnrollWish& wish = {});

}  // namespace hvi::gen
