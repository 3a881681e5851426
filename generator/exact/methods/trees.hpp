// Bicoloured rooted trees: the Taylor series of a partitioned system is a sum over them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hvi::gen {

/// Colour of a vertex: f in dq/dt = f(q, p) = dH/dp, or g in dp/dt = g(q, p) = -dH/dq.
enum class Colour { f, g };

/// Systems that conditions are asked for.
enum class TreeFamily {
    general,    ///< any H(q, p): all trees
    separable,  ///< H = T(p) + U(q): f depends on p alone and g on q, so neighbours differ in
                ///< colour
    nystrom,    ///< T quadratic: f is linear in p besides, so an f has at most one child
};

struct Tree;
using TreePointer = std::shared_ptr<const Tree>;

/// A root with subtrees, which are sorted (see comes_before).
struct Tree {
    Colour root = Colour::f;
    std::vector<TreePointer> children;
    int vertices = 1;
    std::int64_t density = 1;   ///< gamma: product over the vertices of the size of their subtree
    std::int64_t symmetry = 1;  ///< sigma: the number of automorphisms
    std::string text;           ///< `f`, `f[f[f],g]`
};

/// Limit of vertices: densities, symmetries and numbers of trees stay below 2^63.
inline constexpr int most_vertices = 20;

/// Returns the tree of a root and subtrees in any order.
[[nodiscard]] TreePointer graft(Colour root, std::vector<TreePointer> children);

/// Returns whether a tree is listed before another: by root, f before g, and then by children,
/// lexicographically.
[[nodiscard]] bool comes_before(const TreePointer& left, const TreePointer& right);

/// Trees of a family by their root. Roots of one kind carry the same children.
struct Kind {
    std::vector<Colour> roots;
    std::size_t children;  ///< the kind of the children, as an index
    std::size_t most_children;
};
[[nodiscard]] std::vector<Kind> kinds(TreeFamily family);

/// Calls `visit` with each multiset of at most `most_items` items whose sizes add up to `total`, as
/// ascending indices. Precondition: sizes ascend.
void for_each_multiset(const std::vector<int>& sizes, int total, std::size_t most_items,
                       const std::function<void(const std::vector<std::size_t>&)>& visit);

/// Returns all trees of a family with 1, 2, ..., `vertices` vertices, each once, sorted for each
/// number of vertices.
[[nodiscard]] std::vector<std::vector<TreePointer>> trees(TreeFamily family, int vertices);

/// Returns how many trees of a family have 1, 2, ..., `vertices` vertices.
[[nodiscard]] std::vector<std::int64_t> tree_counts(TreeFamily family, int vertices);

}  // namespace hvi::gen
