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

/// Range from first to last; empty where last is less.
struct LoopRange {
    AffineForm first, last;

    friend bool operator==(const LoopRange&, const LoopRange&) = default;
};

/// An index that a sum runs over. Bounds may have the indices of outer sums.
struct Loop {
    std::string index;
    LoopRange range;

    friend bool operator==(const Loop&, const Loop&) = default;
};

/// A family of elements under one name, with indices, the last of which runs fastest, or without.
/// Bounds have sizes.
struct SystemFamily {
    std::string name;
    std::vector<LoopRange> ranges = {};
    Space space = real_line;

    friend bool operator==(const SystemFamily&, const SystemFamily&) = default;
};

/// Returns how many indices tell apart the numbers of a point of this space, where sums stay loops:
/// two for a matrix.
[[nodiscard]] std::size_t component_dimensions(const Space& space);

/// Returns whether families can be coordinates and their conjugates: with the same indices, and of
/// spaces that belong together.
[[nodiscard]] bool are_of_one_body(const SystemFamily& q, const SystemFamily& conjugate);

/// An index of an element: `form`, or mod(form, modulus) + offset, in sizes and indices of loops.
struct ElementIndex {
    AffineForm form;
    std::optional<AffineForm> modulus = {};
    AffineForm offset = {};

    friend bool operator==(const ElementIndex&, const ElementIndex&) = default;
};

/// Returns the index as people write it.
[[nodiscard]] Expression as_expression(const ElementIndex& index);

enum class FamilyKind {
    coordinate,
    conjugate,  ///< a momentum; of a Lagrangian a velocity
    table,
    direction,  ///< vector that second derivatives are multiplied by, an element for each
                ///< coordinate
    direction_of_conjugate,  ///< part of the vector for conjugates
    turn,  ///< of a rotation, which is differentiated by turns in place of its entries
};

/// An element of a family. All but turns are inputs of the graph.
struct Access {
    FamilyKind kind = FamilyKind::coordinate;
    std::size_t family = 0;  ///< among those of its kind
    std::vector<ElementIndex> indices = {};
    Node node = 0;
    std::size_t component = 0;  ///< number of a point, or of a tangent

    friend bool operator==(const Access&, const Access&) = default;
};

/// The derivative of a summand by an access.
struct AccessSlope {
    std::size_t access = 0;
    Scaled value;

    friend bool operator==(const AccessSlope&, const AccessSlope&) = default;
};

/// A sum over loops, each within the one before. Without loops it is a single term.
struct SystemSum {
    std::vector<Loop> loops;
    Scaled value;
    std::vector<std::size_t> accesses;  ///< elements that the value depends on, ascending
    std::vector<AccessSlope> by_q, by_conjugates;  ///< derivatives that are not zero

    friend bool operator==(const SystemSum&, const SystemSum&) = default;
};

/// A number that sums add up to and that other sums depend on, as on two such numbers in a product
/// of two sums.
struct SystemTotal {
    Node node = 0;  ///< input of the graph, with the roles of its sums
    std::vector<SystemSum> sums;
};

}  // namespace hvi::gen
