// Families of variables, and sums over their elements with or without loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/expr/space.hpp"
#include "generator/graph/graph.hpp"
#include "generator/ir/affine_form.hpp"

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
struct SystemFamily {
    std::string name;
    std::vector<LoopRange> ranges = {};
    Space space = real_line;

    friend bool operator==(const SystemFamily&, const SystemFamily&) = default;
};

/// How many indices numbers of a point have where it has several and sums stay loops: two of a
/// matrix.
[[nodiscard]] std::size_t component_dimensions(const Space& space);

/// Whether families are those of coordinates and of their conjugates: with the same indices, and of
/// spaces that belong together.
[[nodiscard]] bool are_of_one_body(const SystemFamily& q, const SystemFamily& conjugate);

/// An index of an element: `form`, or mod(form, modulus) + offset, in sizes and indices of loops.
struct ElementIndex {
    AffineForm form;
    std::optional<AffineForm> modulus = {};
    AffineForm offset = {};

    friend bool operator==(const ElementIndex&, const ElementIndex&) = default;
};

/// The index as people write it.
[[nodiscard]] Expression as_expression(const ElementIndex& index);

enum class FamilyKind {
    coordinate,
    conjugate,  ///< a momentum, of a Lagrangian a velocity
    table,
    direction,  ///< what second derivatives are multiplied by, an element for each coordinate
    direction_of_conjugate,  ///< the same for each conjugate
    turn,  ///< of a rotation: what it is differentiated by in the place of its entries
};

/// An element of a family, which is an input of the graph but for a turn.
struct Access {
    FamilyKind kind = FamilyKind::coordinate;
    std::size_t family = 0;  ///< among those of its kind
    std::vector<ElementIndex> indices = {};
    Node node = 0;
    std::size_t component = 0;  ///< of a point, or of a tangent

    friend bool operator==(const Access&, const Access&) = default;
};

/// The derivative of a summand by an access.
struct AccessSlope {
    std::size_t access = 0;
    Scaled value;

    friend bool operator==(const AccessSlope&, const AccessSlope&) = default;
};

/// A sum over loops, each within the one before; without loops a single term.
struct SystemSum {
    std::vector<Loop> loops;
    Scaled value;
    std::vector<std::size_t> accesses;             ///< that the value depends on, ascending
    std::vector<AccessSlope> by_q, by_conjugates;  ///< that are not zero

    friend bool operator==(const SystemSum&, const SystemSum&) = default;
};

/// A number that sums add up to and that others are made of, as two are in a product of two sums.
struct SystemTotal {
    Node node = 0;  ///< an input of the graph, with the roles of what it is made of
    std::vector<SystemSum> sums;
};

}  // namespace hvi::gen
