// A Hamiltonian system of any size: sums are loops, and what has indices is a family.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/graph/graph.hpp"
#include "generator/ir/affine_form.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// From first to last; empty where last is less.
struct LoopRange {
    AffineForm first, last;

    friend bool operator==(const LoopRange&, const LoopRange&) = default;
};

/// An index that a sum runs over. Bounds may have the indices of sums around it.
struct Loop {
    std::string index;
    LoopRange range;

    friend bool operator==(const Loop&, const Loop&) = default;
};

/// What has a name and indices, the last of which runs fastest; or no index. Bounds have sizes.
struct LoopFamily {
    std::string name;
    std::vector<LoopRange> ranges;
};

/// An index of an element: `form`, or mod(form, modulus) + offset, in sizes and indices of loops.
struct ElementIndex {
    AffineForm form;
    std::optional<AffineForm> modulus = {};
    AffineForm offset = {};

    friend bool operator==(const ElementIndex&, const ElementIndex&) = default;
};

enum class FamilyKind {
    coordinate,
    momentum,
    table,
    direction,  ///< what second derivatives are multiplied by, an element for each coordinate
};

/// An element of a family, which is an input of the graph.
struct Access {
    FamilyKind kind = FamilyKind::coordinate;
    std::size_t family = 0;  ///< among those of its kind
    std::vector<ElementIndex> indices;
    Node node = 0;
};

/// The derivative of a summand by an access.
struct AccessSlope {
    std::size_t access = 0;
    Scaled value;
};

/// A sum over loops, each within the one before; without loops a single term.
struct LoopSum {
    std::vector<Loop> loops;
    Scaled value;
    std::vector<std::size_t> accesses;          ///< that the value depends on, ascending
    std::vector<AccessSlope> by_q, by_momenta;  ///< that are not zero
};

/// A number that ranges are made of.
struct LoopSize {
    std::string name;
    long value = 0;  ///< a default
};

/// Numbers that a program reads from a file.
struct NumbersInFile {
    std::string path;    ///< relative to the directory of the scene, or absolute
    std::string column;  ///< of a CSV file; empty of an NPY file
};

/// Parameters with an index.
struct LoopTable {
    LoopFamily family;
    std::variant<std::vector<Expression>, NumbersInFile> values;  ///< defaults, without symbols
};

/// Where the elements of a family begin: the value for all indices, or one by one, or as a file
/// has them.
struct LoopStart {
    struct Rule {
        std::vector<std::string> indices;
        Scaled value;
        std::vector<std::size_t> accesses;  ///< that the value depends on, ascending
    };
    struct List {
        std::vector<Scaled> values;
        std::vector<std::size_t> accesses;  ///< as of a rule
    };
    std::variant<Rule, List, NumbersInFile> values;
};

/// A sum of sums with its name.
struct LoopInvariant {
    std::string name;
    Expression expression;
    std::vector<LoopSum> sums;
};

/// H(q, p), without time, and what else a scene has. Inputs of the graph are accesses, indices as
/// numbers, and parameters.
struct LoopSystem {
    std::string name, description;
    std::filesystem::path directory;       ///< of the scene
    Expression expression;                 ///< H as it was written
    std::vector<std::string> own_headers;  ///< of functions of the user's own
    std::vector<LoopSize> sizes;
    std::vector<SystemParameter> parameters;  ///< without an index
    std::vector<LoopTable> tables;
    std::vector<LoopFamily> coordinates, momenta;  ///< with the same ranges, in pairs
    Graph graph;
    std::vector<Access> accesses;
    std::vector<LoopSum> sums;       ///< H; each of q alone, of p alone, or of both
    std::vector<LoopStart> initial;  ///< of the coordinates, then of the momenta
    std::vector<LoopInvariant> invariants;

    [[nodiscard]] const LoopFamily& family(const Access& access) const;
    /// H = T(p) + U(q): no summand has both.
    [[nodiscard]] bool is_separable() const;
    /// Whether numbers of it stand in files.
    [[nodiscard]] bool reads_files() const;
};

}  // namespace hvi::gen
