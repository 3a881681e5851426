// Scenes without indices, whose sums are written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/expr/scaled_time.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/read/lagrangian.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// An expression with its name and its place. The ranges in it are ranges in its place's source.
struct NamedExpression {
    std::string name;
    Expression expression;
    Place place;  ///< the place of its whole text
};

/// A vector field on the coordinates along which H or L does not change by the scene's statement.
/// Coordinates without a component do not move.
struct VectorField {
    std::string name;
    std::vector<NamedExpression> components;  ///< by coordinates, in their order
    Place place;                              ///< the place of the name
};

/// An event: see IndexedEvent.
struct SceneEvent {
    std::string name;
    Place place;  ///< the place of the name
    NamedExpression zero;
    EventDirection direction = EventDirection::both;
    long stop = 0;
    std::vector<NamedExpression> set;  ///< values by the names of variables, in their order
    std::optional<Place> canonical = {};
    std::optional<NamedExpression> cooldown = {}, period = {};
    bool is_kink = false;  ///< true for a kink of H, which ends a step there
};

/// The scale of the time: see IndexedScale.
struct SceneScale {
    TimeScale kind = TimeScale::expression;
    NamedExpression expression;  ///< empty unless `kind` is an expression
    Place place;                 ///< the place of the key
};

/// Parts of H: see IndexedSplit.
struct SceneSplit {
    std::vector<NamedExpression> parts;
    Place place;
    SmallSteps small_steps = {};
};

/// A scene without indices, with its words checked: every symbol is a variable, a parameter, pi, e,
/// or, in H, L and [exact], the time t; names are free and differ. Its variables are coordinates
/// and the momenta of a Hamiltonian, or the velocities of a Lagrangian.
struct WrittenOutScene {
    std::string name, description;                    ///< texts of the scene
    std::variant<Hamiltonian, Lagrangian> mechanics;  ///< H or L, with fixed parameters as numbers
    std::vector<Parameter> parameters;                ///< all, in the order of the file
    OwnFunctions own;                                 ///< functions that H and invariants may call
    std::vector<NamedExpression> invariants;          ///< in the order of the file
    std::set<std::string> approximate;  ///< invariants that are said to be nearly conserved
    std::vector<VectorField> fields;    ///< fields of [symmetries], in the order of the file
    std::vector<SceneEvent> events;     ///< in the order of the file; then kinks of H
    std::optional<SceneSplit> split;
    std::optional<SceneScale> scale;       ///< present until H is replaced by the H of scaled time
    std::optional<ScaledTime> scaled;      ///< present from then on
    std::vector<NamedExpression> initial;  ///< coordinates first, then the other variables
    std::vector<NamedExpression> exact;    ///< functions of t in the order of `initial`; or empty
};

/// Writes all sums of a scene out, replaces names with indices by single names, puts definitions
/// in, and computes parameters that are made of others. A name in an index or a range becomes a
/// number, and is no parameter of the result. Throws InputError where a word has no meaning or
/// stands in the wrong place, for more than 64 parameters, and for more than
/// most_degrees_of_freedom; `why` is the reason for writing out that the last error gives.
[[nodiscard]] WrittenOutScene unrolled(const Scene& scene, const std::string& why = "");

/// Returns H or L of the scene.
[[nodiscard]] const MechanicalFunction& function_of(const WrittenOutScene& scene);
[[nodiscard]] MechanicalFunction& function_of(WrittenOutScene& scene);

/// Returns coordinates, then momenta or velocities.
[[nodiscard]] std::vector<std::string> variables(const WrittenOutScene& scene);

/// Returns H. Throws MathError, with the place of L, where the scene has a Lagrangian.
[[nodiscard]] const Hamiltonian& hamiltonian_of(const WrittenOutScene& scene);

}  // namespace hvi::gen
