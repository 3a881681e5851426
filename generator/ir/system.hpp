// A Hamiltonian or Lagrangian system of any size: the content of a scene as one graph, and the
// findings in it. Straight-line code is a sum without loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/expr/scaled_time.hpp"
#include "generator/ir/part.hpp"
#include "generator/ir/sites.hpp"
#include "generator/ir/structure.hpp"

namespace hvi::gen {

/// A parameter of the stepper; its value is a default.
struct SystemParameter {
    std::string name;
    Expression value;
    Node node = 0;
};

/// A number in the bounds of ranges.
struct SystemSize {
    std::string name;
    long value = 0;  ///< a default
};

/// Numbers that a program reads from a file.
struct NumbersInFile {
    std::string path;    ///< relative to the directory of the scene, or absolute
    std::string column;  ///< of a CSV file; empty for an NPY file
};

/// Parameters with an index.
struct SystemTable {
    SystemFamily family;
    std::variant<std::vector<Expression>, NumbersInFile> values;  ///< defaults, without symbols
};

/// Initial values of the elements of a family: one formula for all indices, or the numbers of all
/// elements one by one, or numbers of a file.
struct SystemStart {
    struct Rule {
        std::vector<std::string> indices;
        Scaled value;
        std::vector<std::size_t> accesses = {};  ///< elements that the value depends on, ascending
    };
    struct List {
        std::vector<Scaled> values;
        std::vector<std::size_t> accesses = {};  ///< as in Rule
    };
    /// Numbers of a point, for all indices of the family except those of its numbers.
    struct Points {
        std::vector<std::string> indices;
        std::vector<Scaled> values;
        std::vector<std::size_t> accesses = {};  ///< as in Rule
    };
    /// -H at the initial values: the start of the momentum of the time.
    struct MinusEnergy {};
    std::variant<Rule, List, NumbersInFile, Points, MinusEnergy> values;
};

/// A named value, as a sum of sums.
struct SystemValue {
    std::string name;
    Expression expression;  ///< as it was written
    std::vector<SystemSum> sums;
};

/// H(q, p) or L(q, v), its variables, its derivatives, and all else of a scene. Inputs of the graph
/// are accesses, indices as numbers, sizes, parameters and the time. The conjugates of the
/// coordinates are the momenta, or on the Lagrangian side the velocities; there the momenta are
/// only names.
///
/// A system is *written out* where no family of its variables has an index. Then H or L is one sum
/// without loops, and every variable is an access, coordinates before conjugates. Families of
/// rotations are the last of the coordinates, and of the conjugates.
struct System {
    std::string name, description;    ///< of the scene; may be empty
    std::filesystem::path directory;  ///< of the scene
    Side side = Side::hamiltonian;
    Expression expression;        ///< of the function, as it was written
    bool is_transformed = false;  ///< whether `expression` is an L, and H its Legendre transform
    std::vector<std::string> own_headers;  ///< headers of functions of the user's own

    std::vector<SystemSize> sizes;
    std::vector<SystemParameter> parameters;  ///< without an index, in the order of the scene
    std::vector<SystemTable> tables;
    std::vector<SystemFamily> coordinates, conjugates;  ///< with the same ranges, in pairs
    std::vector<std::string> momenta;  ///< of a Lagrangian, one for each coordinate

    Graph graph;
    std::optional<Node> time;          ///< the input t, where the function depends on it
    std::optional<ScaledTime> scaled;  ///< where the time is a coordinate
    std::vector<Access> accesses;
    std::vector<SystemTotal> totals;  ///< each depends on earlier ones only
    /// H or L; with loops each sum depends on q alone, on p alone, or on both. Sums of value 0 have
    /// derivatives through totals.
    std::vector<SystemSum> sums;
    std::vector<SystemSum> energy;     ///< H, or v dL/dv - L; H before passes that make another one
    std::vector<SystemStart> initial;  ///< of coordinates, then of conjugates; or empty
    std::vector<SystemValue> invariants;  ///< in the order of the scene

    Structure structure;
    SecondOrder second;
    std::optional<Sites> sites;             ///< where the system is a lattice, and not written out
    std::optional<HamiltonianParts> parts;  ///< where steps are flows of parts of H

    [[nodiscard]] const SystemFamily& family(const Access& access) const;
    [[nodiscard]] bool is_written_out() const;
    /// Returns the number for the default values of sizes. NOTE: a rotation has three, and nine q;
    /// with loops these are elements of its family.
    [[nodiscard]] std::size_t degrees_of_freedom() const;
    /// Returns whether numbers of the system stand in files.
    [[nodiscard]] bool reads_files() const;

    /// Returns the names of the momenta, or of the velocities: one for each family.
    [[nodiscard]] std::vector<std::string> momentum_names() const;
    /// Return `H` or `L`, and the letter of its conjugates, `p` or `v`.
    [[nodiscard]] char function_letter() const { return side == Side::hamiltonian ? 'H' : 'L'; }
    [[nodiscard]] char conjugate_letter() const { return side == Side::hamiltonian ? 'p' : 'v'; }
};

// ---- systems that are written out ----

/// Return inputs of the graph, in the order of the families: rotations have nine coordinates and
/// three conjugates.
[[nodiscard]] std::vector<Node> coordinate_nodes(const System& system);
[[nodiscard]] std::vector<Node> conjugate_nodes(const System& system);

/// Return H or L as one node, and the energy.
[[nodiscard]] const Scaled& function_of(const System& system);
[[nodiscard]] const Scaled& energy_of(const System& system);
[[nodiscard]] const Scaled& value_of(const SystemValue& value);

/// Return the first derivatives by each degree of freedom, zeros included; for a rotation by its
/// turns.
[[nodiscard]] std::vector<Scaled> by_coordinates(const System& system);
[[nodiscard]] std::vector<Scaled> by_conjugates(const System& system);

[[nodiscard]] const Hessian& hessian_of(const System& system);

/// Returns the initial values: coordinates, then conjugates; or empty.
[[nodiscard]] std::vector<Scaled> start_of(const System& system);

/// Returns how many bodies turn, for the default values of sizes.
[[nodiscard]] std::size_t bodies_of(const System& system);

/// Return how many of its families are rotations, and how many are not.
[[nodiscard]] std::size_t rotations_of(const System& system);
[[nodiscard]] std::size_t flat_coordinates(const System& system);

/// Returns the coordinates that do not occur in the function, so that their momenta are constant.
[[nodiscard]] std::vector<std::size_t> cyclic_coordinates(const System& system);

// ---- all systems ----

/// Returns how many elements a family has for these sizes. Precondition: no range is empty.
[[nodiscard]] std::size_t element_count(const SystemFamily& family,
                                        const std::map<std::string, long>& sizes);

/// Returns whether H = T(p) + U(q): no derivative by q depends on p, and none by p on q.
/// Precondition: with loops, the derivatives are there.
[[nodiscard]] bool is_separable(const System& system);

/// Returns stable text, for people and tests: the computation of each node, `#7: product #3 #4`,
/// and the nodes of the function, its derivatives, the initial data and the invariants.
[[nodiscard]] std::string dump(const System& system);

/// Stops the program (HVI_CHECK) where the record contradicts itself: a node that needs a later one
/// or depends on something else than its arguments, an access that is no input, slopes by variables
/// that do not occur, tables of other sizes than there are variables.
void verify(const System& system);

/// Returns whether the texts are equal.
[[nodiscard]] bool operator==(const System& left, const System& right);

}  // namespace hvi::gen
