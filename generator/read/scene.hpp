// Scenes as they are written: a Hamiltonian or a Lagrangian with its numbers, and questions about
// its motion. Indices are indices, and sums run over them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "generator/expr/event_direction.hpp"
#include "generator/expr/side.hpp"
#include "generator/expr/small_steps.hpp"
#include "generator/read/method.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/read/time_scale.hpp"
#include "generator/read/unroll.hpp"

namespace hvi::gen {

/// An expression with its name.
struct NamedIndexed {
    std::string name;
    IndexedExpression expression;
    Place place;               ///< the place of its whole text
    Place place_of_name = {};  ///< the place of an invariant
};

/// Values in the order of their indices, of which the last runs fastest. A matrix [[1, 2, 3], [4,
/// 5, 6]] has six values, and the extents 2 and 3.
struct ValueList {
    std::vector<IndexedExpression> values;
    std::vector<std::size_t> extents;
};

/// Numbers that stay in their file, as there are many of them.
struct ValueFile {
    std::string path;                   ///< the path in the scene file
    std::optional<std::string> column;  ///< the name of a column of a CSV file
    std::vector<std::size_t> extents;   ///< extents as in a ValueList
};

/// A rotation as nine entries row by row. They come from `identity`, an axis and an angle, a
/// quaternion, or the entries themselves.
struct RotationValue {
    std::vector<IndexedExpression> entries;
    std::vector<std::string> indices = {};  ///< indices of a rule: `"R[k]" = {...}`
};

/// Returns the number of values.
[[nodiscard]] std::size_t count(const ValueFile& file);

/// The value for every index: `"x[i]" = "sin(i)"`.
struct ValueRule {
    std::vector<std::string> indices;
    IndexedExpression value;
};

/// A parameter of `--hamiltonian` that has no value yet.
struct NoValue {};

/// The meaning of a name, or of a name with an index.
struct IndexedValue {
    std::string name;  ///< without an index
    std::variant<IndexedExpression, ValueList, ValueRule, ValueFile, RotationValue, NoValue> value;
    Place place;           ///< the place of the name
    Place place_of_value;  ///< the place of all values
};

/// The values in a section.
struct ValueTable {
    std::vector<IndexedValue> values;  ///< in the order of the file
    Place place;                       ///< the place of the section
};

/// A vector field on the coordinates, by its components.
struct IndexedField {
    std::string name;
    ValueTable components;
    Place place;  ///< the place of the name
};

/// A function that passes through zero during a run, and the actions at that moment.
struct IndexedEvent {
    std::string name;
    Place place;             ///< the place of the name
    IndexedExpression zero;  ///< a function of the variables and the time
    EventDirection direction = EventDirection::both;
    long stop = 0;                        ///< the number of the event that ends the run; 0 for none
    std::optional<ValueTable> set = {};   ///< values of variables that jump
    std::optional<Place> canonical = {};  ///< the place of the claim that the jump is symplectic
    std::optional<IndexedExpression> cooldown = {}, period = {};  ///< functions of parameters
};

/// The key `scale` of [time]: dt/ds.
struct IndexedScale {
    TimeScale kind = TimeScale::expression;
    IndexedExpression expression;  ///< empty unless `kind` is an expression
    Place place;                   ///< the place of the key
};

/// Parts of H for splittings, where the scene names none or they are not to be those of the scene.
enum class SplitChoice {
    automatic,     ///< those that are found
    none,          ///< T(p) and U(q)
    jacobi,        ///< Kepler orbits about the centre of mass of the bodies before, and the rest
    heliocentric,  ///< Kepler orbits about the first body, the motion of that, and the rest
};

/// Returns the word of users for it.
[[nodiscard]] constexpr std::string_view word_of(SplitChoice choice) {
    switch (choice) {
    case SplitChoice::automatic: return "auto";
    case SplitChoice::none: return "none";
    case SplitChoice::jacobi: return "jacobi";
    case SplitChoice::heliocentric: break;
    }
    return "heliocentric";
}

[[nodiscard]] constexpr bool is_of_orbits(SplitChoice choice) {
    return choice == SplitChoice::jacobi || choice == SplitChoice::heliocentric;
}

/// The section [split]: parts of H whose sum it is.
struct IndexedSplit {
    std::vector<NamedIndexed> parts;  ///< in the order of the file, fast ones before the others
    Place place;                      ///< the place of the section
    SmallSteps small_steps = {};
};

/// Parts for splittings; without a word of the user they are T(p) and U(q) where H is their sum,
/// else those that are found.
using SplitOfScene = std::variant<std::monostate, IndexedSplit, SplitChoice>;

/// A part of a function that has a name: `r`, or with indices `d[i]`.
struct Definition {
    std::string name;
    std::vector<std::string> indices;
    IndexedExpression value;
    Place place;  ///< the place of the name
};

/// Wishes of [run].
struct IndexedRun {
    std::shared_ptr<const Source> method;
    std::optional<NamedIndexed> step, until;
};

/// A scene whose text is well-formed. Sums are kept, and a name with indices is one family, whose
/// size may depend on parameters. A scene of `--hamiltonian` has only H and parameters.
struct Scene {
    std::string name;               ///< the key `name`, else that of the file without its ending
    std::string description;        ///< the key `description`: one line; or empty
    Side side = Side::hamiltonian;  ///< the kind of `function`: H or L
    NameTexts coordinates;
    NameTexts conjugates;                  ///< momenta, or velocities
    NameTexts rotations, angular_momenta;  ///< empty where there are none
    IndexedExpression function;
    std::string origin;                    ///< the words of the command line
    std::filesystem::path directory;       ///< the directory of relative paths
    std::vector<IndexedValue> parameters;  ///< no ValueRule and no RotationValue among them
    std::set<std::string> fixed;           ///< parameters that a program cannot change
    OwnFunctions own;                      ///< functions that H and invariants may call
    std::vector<Definition> definitions;
    std::vector<NamedIndexed> invariants;  ///< in the order of the file
    std::set<std::string> approximate;     ///< invariants that are said to be nearly conserved
    std::vector<IndexedField> fields;      ///< fields of [symmetries]
    std::vector<IndexedEvent> events;      ///< in the order of the file
    SplitOfScene split = {};
    std::optional<IndexedScale> scale = {};  ///< none where steps are of time
    std::optional<Place> kinks = {};         ///< the key, where kinks of H end steps
    std::optional<ValueTable> initial;
    std::optional<ValueTable> exact;
    IndexedRun run;
    std::optional<Place> place;  ///< the word that names the scene; none for a file alone
    std::string text = {};       ///< the text of its file
};

/// `the Hamiltonian` or `the Lagrangian`.
[[nodiscard]] std::string_view name_of_function(const Scene& scene);

/// Throws InputError where the scene has rotations. `what` is the feature that does not support
/// them.
void refuse_rotations(const Scene& scene, std::string_view what);

/// Throws InputError where the scene scales time. `what` is the feature that does not support it.
void refuse_scale(const Scene& scene, std::string_view what);

/// Returns the name of the scene, or its words on the command line where it has no name.
[[nodiscard]] const std::string& title(const Scene& scene);

/// Reads the scene in a TOML file of at most 1 MiB, as CONTRACT.md has it. Throws InputError with
/// the line of the file.
[[nodiscard]] Scene scene_from_file(const std::filesystem::path& path);

/// Reads the text of such a file; the source's name is the file's name.
[[nodiscard]] Scene scene_from_toml(const Source& file);

/// Reads the H of `--hamiltonian`, as hamiltonian_from_text() does, with the values of its sizes.
/// Throws InputError as hamiltonian_from_text() does.
[[nodiscard]] Scene scene_from_hamiltonian(const std::shared_ptr<const Source>& expression,
                                           const std::shared_ptr<const Source>& coordinates,
                                           const std::shared_ptr<const Source>& momenta,
                                           const std::vector<Parameter>& values);

/// Returns the scene that the command line names: one that comes with the program (`kepler`), else
/// the one in the file. `values` replace values of its parameters. Throws InputError, with a
/// suggestion, where there is neither.
[[nodiscard]] Scene find_scene(const Given& name_or_file,
                               const std::vector<Parameter>& values = {});

/// Returns the TOML of a scene that comes with the program, else of the file. Throws InputError
/// where find_scene() finds no scene; the text is not checked.
[[nodiscard]] std::string scene_text(const Given& name_or_file);

/// A scene that comes with the program.
struct SceneEntry {
    std::string_view name;
    std::string description;
    std::size_t degrees_of_freedom = 0;  ///< the number with the values in the file
};
[[nodiscard]] std::vector<SceneEntry> scenes();

/// Returns the number of coordinates for the sizes in the scene. Throws InputError where a bound of
/// an index is no whole number, and where an index has no value.
[[nodiscard]] std::size_t degrees_of_freedom(const Scene& scene);

/// Returns the index of the k-th value of a list: 1, 2, ..., or of a matrix 1,1, 1,2, ...
[[nodiscard]] Index index_of_value(const ValueList& list, std::size_t k);

/// Gives a parameter another value: `N`, or `m[2]` of a list. Returns whether there is such a
/// parameter.
[[nodiscard]] bool assign(Scene& scene, const Parameter& parameter);

/// Throws InputError where a parameter of the method has the name of a variable without an index.
void check_together(const Method& method, const Scene& scene);

/// Gives a value to a parameter of the scene, of the method, or of both. In the scene it is fixed
/// from then on. Throws InputError when the name is that of a variable, and when neither has the
/// parameter.
void set_parameter(Method& method, Scene& scene, Parameter parameter);

}  // namespace hvi::gen
