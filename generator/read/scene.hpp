// Scenes: a Hamiltonian or a Lagrangian with its numbers, and what one wants to know of its motion,
// as it is written: indices are indices, and sums run over them.
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
#include "generator/read/method.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/read/time_scale.hpp"
#include "generator/read/unroll.hpp"

namespace hvi::gen {

/// An expression with its name.
struct NamedIndexed {
    std::string name;
    IndexedExpression expression;
    Place place;               ///< of its whole text
    Place place_of_name = {};  ///< of an invariant
};

/// Values one by one, in the order of indices of which the last runs fastest: those of a matrix
/// [[1, 2, 3], [4, 5, 6]] are six, with the extents 2 and 3.
struct ValueList {
    std::vector<IndexedExpression> values;
    std::vector<std::size_t> extents;
};

/// Numbers of a file that stay there, as there are many of them.
struct ValueFile {
    std::string path;                   ///< as the scene has it
    std::optional<std::string> column;  ///< of a CSV file
    std::vector<std::size_t> extents;   ///< as of a ValueList
};

/// A rotation: nine entries row by row, of `identity`, of an axis and an angle, of a quaternion or
/// as they are written.
struct RotationValue {
    std::vector<IndexedExpression> entries;
    std::vector<std::string> indices = {};  ///< of all rotations: `"R[k]" = {...}`
};

/// How many values there are.
[[nodiscard]] std::size_t count(const ValueFile& file);

/// The value for every index: `"x[i]" = "sin(i)"`.
struct ValueRule {
    std::vector<std::string> indices;
    IndexedExpression value;
};

/// A parameter of `--hamiltonian` that has no value yet.
struct NoValue {};

/// Meaning of a name, or of a name with an index.
struct IndexedValue {
    std::string name;  ///< without an index
    std::variant<IndexedExpression, ValueList, ValueRule, ValueFile, RotationValue, NoValue> value;
    Place place;           ///< of the name
    Place place_of_value;  ///< of all values
};

/// The values in a section.
struct ValueTable {
    std::vector<IndexedValue> values;  ///< in the order of the file
    Place place;                       ///< of the section
};

/// A vector field on the coordinates, by its components.
struct IndexedField {
    std::string name;
    ValueTable components;
    Place place;  ///< of the name
};

/// A function that passes through zero on the way, and what happens there.
struct IndexedEvent {
    std::string name;
    Place place;             ///< of the name
    IndexedExpression zero;  ///< of the variables and the time
    EventDirection direction = EventDirection::both;
    long stop = 0;                        ///< the run ends at this one; 0 for none
    std::optional<ValueTable> set = {};   ///< what jumps
    std::optional<Place> canonical = {};  ///< of the claim that the jump is symplectic
    std::optional<IndexedExpression> cooldown = {}, period = {};  ///< of parameters
};

/// The key `scale` of [time]: dt/ds.
struct IndexedScale {
    TimeScale kind = TimeScale::expression;
    IndexedExpression expression;  ///< of the kind of this name
    Place place;                   ///< of the key
};

/// Parts of a function that have a name: `r`, or with indices `d[i]`.
struct Definition {
    std::string name;
    std::vector<std::string> indices;
    IndexedExpression value;
    Place place;  ///< of the name
};

/// Wishes of [run].
struct IndexedRun {
    std::shared_ptr<const Source> method;
    std::optional<NamedIndexed> step, until;
};

/// A scene whose text is well-formed. Sums are sums, and what has indices is one family, of a size
/// that parameters may give. That of `--hamiltonian` has H and parameters alone.
struct Scene {
    std::string name;               ///< the key `name`, else that of the file without its ending
    std::string description;        ///< the key `description`: one line; or empty
    Side side = Side::hamiltonian;  ///< which of the two `function` is
    NameTexts coordinates;
    NameTexts conjugates;                  ///< momenta, or velocities
    NameTexts rotations, angular_momenta;  ///< empty where there are none
    IndexedExpression function;
    std::string origin;                    ///< as the command line has it
    std::filesystem::path directory;       ///< that paths of files are relative to
    std::vector<IndexedValue> parameters;  ///< no ValueRule and no RotationValue among them
    std::set<std::string> fixed;           ///< parameters that a program cannot change
    OwnFunctions own;                      ///< that H and invariants may call
    std::vector<Definition> definitions;
    std::vector<NamedIndexed> invariants;    ///< in the order of the file
    std::set<std::string> approximate;       ///< invariants that are said to be nearly conserved
    std::vector<IndexedField> fields;        ///< of [symmetries]
    std::vector<IndexedEvent> events;        ///< in the order of the file
    std::optional<IndexedScale> scale = {};  ///< where steps are of another variable than time
    std::optional<Place> kinks = {};         ///< of the key, where kinks of H end steps
    std::optional<ValueTable> initial;
    std::optional<ValueTable> exact;
    IndexedRun run;
    std::optional<Place> place;  ///< of the word that names it, for errors; none of a file alone
    std::string text = {};       ///< of its file
};

/// `the Hamiltonian` or `the Lagrangian`.
[[nodiscard]] std::string_view name_of_function(const Scene& scene);

/// Throws InputError where the scene has rotations. `what` is what is not built for these.
void refuse_rotations(const Scene& scene, std::string_view what);

/// Throws InputError where the scene scales time. `what` is what is not built for that.
void refuse_scale(const Scene& scene, std::string_view what);

/// Name of the scene, or where it has none what the command line has for it.
[[nodiscard]] const std::string& title(const Scene& scene);

/// The scene in a TOML file of at most 1 MiB, as CONTRACT.md has it. Throws InputError with the
/// line of the file.
[[nodiscard]] Scene scene_from_file(const std::filesystem::path& path);

/// Reads the text of such a file; the source's name is that of the file.
[[nodiscard]] Scene scene_from_toml(const Source& file);

/// The H of `--hamiltonian`, as hamiltonian_from_text() reads it, with the values that it needs for
/// its sizes. Throws InputError as that does.
[[nodiscard]] Scene scene_from_hamiltonian(const std::shared_ptr<const Source>& expression,
                                           const std::shared_ptr<const Source>& coordinates,
                                           const std::shared_ptr<const Source>& momenta,
                                           const std::vector<Parameter>& values);

/// The scene that the command line names: one that comes with the program (`kepler`), else that of
/// the file; with other values for those of its parameters that `values` names. Throws InputError,
/// with what may have been meant, where there is neither.
[[nodiscard]] Scene find_scene(const Given& name_or_file,
                               const std::vector<Parameter>& values = {});

/// The TOML of a scene that comes with the program, else of the file. Throws InputError as
/// find_scene() does, but for what stands in it.
[[nodiscard]] std::string scene_text(const Given& name_or_file);

/// The scenes that come with the program, by name.
struct SceneEntry {
    std::string_view name;
    std::string description;
    std::size_t degrees_of_freedom = 0;  ///< with the values that its parameters have in it
};
[[nodiscard]] std::vector<SceneEntry> scenes();

/// How many coordinates it has, for the sizes that it names. Throws InputError where a bound of an
/// index is no whole number, and where an index has no value.
[[nodiscard]] std::size_t degrees_of_freedom(const Scene& scene);

/// The index of the k-th value of a list: 1, 2, ..., or of a matrix 1,1, 1,2, ...
[[nodiscard]] Index index_of_value(const ValueList& list, std::size_t k);

/// Gives a parameter another value: `N`, or `m[2]` of a list. Whether there is such a parameter.
[[nodiscard]] bool assign(Scene& scene, const Parameter& parameter);

/// Throws InputError where a parameter of the method is called as a variable without an index.
void check_together(const Method& method, const Scene& scene);

/// Gives a value to a parameter of the scene, or of the method, or of both, where it is fixed in
/// the scene. Throws InputError when it is a variable, and when neither has it.
void set_parameter(Method& method, Scene& scene, Parameter parameter);

}  // namespace hvi::gen
