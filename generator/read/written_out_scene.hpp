// Scenes without indices: their sums are written out.
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

/// An expression with its name and where it stands. The ranges in it are ranges in its place's
/// source.
struct NamedExpression {
    std::string name;
    Expression expression;
    Place place;  ///< of its whole text
};

/// A vector field on the coordinates along which H or L is said not to change; those that are not
/// named do not move.
struct VectorField {
    std::string name;
    std::vector<NamedExpression> components;  ///< by the names of coordinates, in their order
    Place place;                              ///< of the name
};

/// An event: see IndexedEvent.
struct SceneEvent {
    std::string name;
    Place place;  ///< of the name
    NamedExpression zero;
    EventDirection direction = EventDirection::both;
    long stop = 0;
    std::vector<NamedExpression> set;  ///< by the names of variables, in their order
    std::optional<Place> canonical = {};
    std::optional<NamedExpression> cooldown = {}, period = {};
    bool is_kink = false;  ///< of H, which ends a step there
};

/// The scale of the time: see IndexedScale.
struct SceneScale {
    TimeScale kind = TimeScale::expression;
    NamedExpression expression;  ///< of the kind of this name
    Place place;                 ///< of the key
};

/// Statements of a scene about its motion, checked as far as words go: every symbol is a variable,
/// a parameter, pi, e, or, in H, L and [exact], the time t; names are free and differ. Its
/// variables are coordinates, and momenta where it has a Hamiltonian, velocities where it has a
/// Lagrangian.
struct WrittenOutScene {
    std::string name, description;                    ///< as the scene has them
    std::variant<Hamiltonian, Lagrangian> mechanics;  ///< with the values of fixed parameters
    std::vector<Parameter> parameters;                ///< all, in the order of the file
    OwnFunctions own;                                 ///< that H and invariants may call
    std::vector<NamedExpression> invariants;          ///< in the order of the file
    std::set<std::string> approximate;     ///< invariants that are said to be nearly conserved
    std::vector<VectorField> fields;       ///< of [symmetries], in the order of the file
    std::vector<SceneEvent> events;        ///< in the order of the file; then kinks of H
    std::optional<SceneScale> scale;       ///< until H is that of scaled time
    std::optional<ScaledTime> scaled;      ///< from then on
    std::vector<NamedExpression> initial;  ///< of the coordinates, then of the other variables
    std::vector<NamedExpression> exact;    ///< as `initial`, as functions of t; or empty
};

/// The scene with all sums written out, names with indices as so many names, definitions put in,
/// and parameters that are made of others computed. What stands in an index or a range is a number:
/// no parameter of the result. Throws InputError where a word has no meaning or stands where it may
/// not, for more than 64 parameters, and, with `why` it is written out, for more than
/// most_degrees_of_freedom.
[[nodiscard]] WrittenOutScene unrolled(const Scene& scene, const std::string& why = "");

/// H or L of the scene.
[[nodiscard]] const MechanicalFunction& function_of(const WrittenOutScene& scene);
[[nodiscard]] MechanicalFunction& function_of(WrittenOutScene& scene);

/// Coordinates, then momenta or velocities.
[[nodiscard]] std::vector<std::string> variables(const WrittenOutScene& scene);

/// H. Throws MathError, with the place of L, where the scene has a Lagrangian.
[[nodiscard]] const Hamiltonian& hamiltonian_of(const WrittenOutScene& scene);

}  // namespace hvi::gen
