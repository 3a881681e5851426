// Scenes as they are written: indices are indices, and sums run over them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "generator/expr/side.hpp"
#include "generator/read/written_out_scene.hpp"

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
};

/// How many values there are.
[[nodiscard]] std::size_t count(const ValueFile& file);

/// The value for every index: `"x[i]" = "sin(i)"`.
struct ValueRule {
    std::vector<std::string> indices;
    IndexedExpression value;
};

/// What a name, or a name with an index, stands for.
struct IndexedValue {
    std::string name;  ///< without an index
    std::variant<IndexedExpression, ValueList, ValueRule, ValueFile, RotationValue> value;
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

/// Parts of a function that have a name: `r`, or with indices `d[i]`.
struct Definition {
    std::string name;
    std::vector<std::string> indices;
    IndexedExpression value;
    Place place;  ///< of the name
};

/// What [run] asks for.
struct IndexedRun {
    std::shared_ptr<const Source> method;
    std::optional<NamedIndexed> step, until;
};

/// A scene whose text is well-formed; whether its words have a meaning is not yet looked at. Sums
/// are sums, and what has indices is one family, of a size that parameters may give.
struct Scene {
    std::string name, description;
    Side side = Side::hamiltonian;  ///< which of the two `function` is
    NameTexts coordinates;
    NameTexts conjugates;                  ///< momenta, or velocities
    NameTexts rotations, angular_momenta;  ///< empty where there are none
    IndexedExpression function;
    std::string origin;                    ///< as the command line has it
    std::filesystem::path directory;       ///< that paths of files are relative to
    std::vector<IndexedValue> parameters;  ///< no ValueRule and no RotationValue among them
    std::set<std::string> fixed;           ///< parameters that a program cannot change
    OwnFunctions own;
    std::vector<Definition> definitions;
    std::vector<NamedIndexed> invariants;
    std::set<std::string> approximate;  ///< names of some of them
    std::vector<IndexedField> fields;
    ValueTable initial;
    std::optional<ValueTable> exact;
    IndexedRun run;
};

/// The scene in a TOML file of at most 1 MiB, as CONTRACT.md has it. Throws InputError with the
/// line of the file.
[[nodiscard]] Scene indexed_scene_from_file(const std::filesystem::path& path);

/// The same for the text of such a file; the source's name is that of the file.
[[nodiscard]] Scene indexed_scene_from_toml(const Source& file);

/// The scene that the command line names, as find_scene() finds it, with other values for those of
/// its parameters that `values` names.
[[nodiscard]] Scene find_indexed_scene(const Given& name_or_file,
                                       const std::vector<Parameter>& values = {});

/// How many coordinates it has, for the sizes that it names. Throws InputError where a bound of an
/// index is no whole number, and where an index has no value.
[[nodiscard]] std::size_t degrees_of_freedom(const Scene& scene);

/// Gives a parameter another value: `N`, or `m[2]` of a list. Whether there is such a parameter.
[[nodiscard]] bool assign(Scene& scene, const Parameter& parameter);

/// The scene with all sums written out, names with indices as so many names, definitions put in,
/// and parameters that are made of others computed. What stands in an index or a range is a number:
/// no parameter of the result. Throws InputError where a word has no meaning or stands where it may
/// not, for more than most_degrees_of_freedom, and for more than 64 parameters or invariants.
[[nodiscard]] WrittenOutScene unrolled(const Scene& scene);

/// What a scene of any size says besides its motion: names, parameters without an index, sizes, and
/// what [run] asks for. Throws InputError as unrolled() does for these.
[[nodiscard]] WrittenOutScene without_motion(Scene scene);

}  // namespace hvi::gen
