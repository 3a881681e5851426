// A Hamiltonian or Lagrangian system of any size: what a scene says, as one graph, and what is
// found in it. Straight-line code is a sum without loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/expr/scaled_time.hpp"
#include "generator/ir/sites.hpp"
#include "generator/ir/structure.hpp"

namespace hvi::gen {

/// A parameter that stays one: its value is a default.
struct SystemParameter {
    std::string name;
    Expression value;
    Node node = 0;
};

/// A number that ranges are made of.
struct SystemSize {
    std::string name;
    long value = 0;  ///< a default
};

/// Numbers that a program reads from a file.
struct NumbersInFile {
    std::string path;    ///< relative to the directory of the scene, or absolute
    std::string column;  ///< of a CSV file; empty of an NPY file
};

/// Parameters with an index.
struct SystemTable {
    SystemFamily family;
    std::variant<std::vector<Expression>, NumbersInFile> values;  ///< defaults, without symbols
};

/// Where the elements of a family begin: the value for all indices, or the numbers of all elements
/// one by one, or as a file has them.
struct SystemStart {
    struct Rule {
        std::vector<std::string> indices;
        Scaled value;
        std::vector<std::size_t> accesses = {};  ///< that the value depends on, ascending
    };
    struct List {
        std::vector<Scaled> values;
        std::vector<std::size_t> accesses = {};  ///< as of a rule
    };
    /// The numbers of the point for all indices but those of its numbers.
    struct Points {
        std::vector<std::string> indices;
        std::vector<Scaled> values;
        std::vector<std::size_t> accesses = {};  ///< as of a rule
    };
    /// -H of where all else begins: of the momentum of the time.
    struct MinusEnergy {};
    std::variant<Rule, List, NumbersInFile, Points, MinusEnergy> values;
};

/// A sum of sums with its name.
struct SystemValue {
    std::string name;
    Expression expression;  ///< as it was written
    std::vector<SystemSum> sums;
};

/// H(q, p) or L(q, v), its variables, its derivatives, and what else a scene has. Inputs of the
/// graph are accesses, indices as numbers, sizes, parameters and the time. The conjugates of the
/// coordinates are the momenta, or on the Lagrangian side the velocities; there the momenta are
/// names alone.
///
/// A system is *written out* where no family of its variables has an index. Then H or L is one sum
/// without loops, every variable is an access, coordinates before conjugates, and families that
/// are rotations are the last of either.
struct System {
    std::string name, description;    ///< of the scene; may be empty
    std::filesystem::path directory;  ///< of the scene
    Side side = Side::hamiltonian;
    Expression expression;                 ///< of the function, as it was written
    bool is_transformed = false;           ///< that is an L, and H its Legendre transform
    std::vector<std::string> own_headers;  ///< of functions of the user's own

    std::vector<SystemSize> sizes;
    std::vector<SystemParameter> parameters;  ///< without an index, in the order of the scene
    std::vector<SystemTable> tables;
    std::vector<SystemFamily> coordinates, conjugates;  ///< with the same ranges, in pairs
    std::vector<std::string> momenta;  ///< of a Lagrangian, one for each coordinate

    Graph graph;
    std::optional<Node> time;          ///< the input t, where the function depends on it
    std::optional<ScaledTime> scaled;  ///< where it is a coordinate
    std::vector<Access> accesses;
    std::vector<SystemTotal> totals;  ///< each made of those before it
    /// H or L; with loops each of q alone, of p alone, or of both. Those of value 0 have
    /// derivatives through totals.
    std::vector<SystemSum> sums;
    std::vector<SystemSum> energy;     ///< H, or v dL/dv - L; H before passes that make another one
    std::vector<SystemStart> initial;  ///< of coordinates, then of conjugates; or empty
    std::vector<SystemValue> invariants;  ///< in the order of the scene

    Structure structure;
    SecondOrder second;
    std::optional<Sites> sites;  ///< where it is a lattice, and not written out

    [[nodiscard]] const SystemFamily& family(const Access& access) const;
    [[nodiscard]] bool is_written_out() const;
    /// With the default values of its sizes. NOTE: a rotation has three, and nine q; with loops
    /// these are elements of its family.
    [[nodiscard]] std::size_t degrees_of_freedom() const;
    /// Whether numbers of it stand in files.
    [[nodiscard]] bool reads_files() const;

    /// Names of the momenta, or of the velocities: one for each family.
    [[nodiscard]] std::vector<std::string> momentum_names() const;
    /// `H` or `L`, and what its conjugates are called, `p` or `v`.
    [[nodiscard]] char function_letter() const { return side == Side::hamiltonian ? 'H' : 'L'; }
    [[nodiscard]] char conjugate_letter() const { return side == Side::hamiltonian ? 'p' : 'v'; }
};

// ---- of a system that is written out ----

/// Inputs of the graph, in the order of the families: rotations have nine coordinates and three
/// conjugates.
[[nodiscard]] std::vector<Node> coordinate_nodes(const System& system);
[[nodiscard]] std::vector<Node> conjugate_nodes(const System& system);

/// H or L as one node, and the energy.
[[nodiscard]] const Scaled& function_of(const System& system);
[[nodiscard]] const Scaled& energy_of(const System& system);
[[nodiscard]] const Scaled& value_of(const SystemValue& value);

/// The first derivatives by each degree of freedom, zeros too: of a rotation those by its turns.
[[nodiscard]] std::vector<Scaled> by_coordinates(const System& system);
[[nodiscard]] std::vector<Scaled> by_conjugates(const System& system);

[[nodiscard]] const Hessian& hessian_of(const System& system);

/// Where it begins: coordinates, then conjugates; or empty.
[[nodiscard]] std::vector<Scaled> start_of(const System& system);

/// How many bodies turn, with the default values of its sizes.
[[nodiscard]] std::size_t bodies_of(const System& system);

/// How many of its families are rotations, and how many are not.
[[nodiscard]] std::size_t rotations_of(const System& system);
[[nodiscard]] std::size_t flat_coordinates(const System& system);

/// The coordinates that do not occur in the function, so that the momenta stay.
[[nodiscard]] std::vector<std::size_t> cyclic_coordinates(const System& system);

// ---- of any ----

/// How many elements a family has for these sizes. Precondition: no range is empty.
[[nodiscard]] std::size_t element_count(const SystemFamily& family,
                                        const std::map<std::string, long>& sizes);

/// H = T(p) + U(q): no slope by the one has the other. Precondition: these are there, with loops.
[[nodiscard]] bool is_separable(const System& system);

/// Stable text, for people and tests: what each node computes, `#7: product #3 #4`, and which nodes
/// are the function, its derivatives, the initial data and the invariants.
[[nodiscard]] std::string dump(const System& system);

/// Stops the program (HVI_CHECK) where the record contradicts itself: a node that needs a later one
/// or depends on something else than its arguments, an access that is no input, slopes by what does
/// not occur, tables of other sizes than there are variables.
void verify(const System& system);

/// Whether the texts are.
[[nodiscard]] bool operator==(const System& left, const System& right);

}  // namespace hvi::gen
