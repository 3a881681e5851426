// The trees without a root in the series of the discrete Hamiltonians.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hvi::gen {

/// The end of an edge at a vertex: the p at the beginning of an arrow, the q at its end, or one of
/// the two equal ends of a link.
enum class End { p, q, link };

/// Returns the end at the other side of the edge.
[[nodiscard]] End other(End end);

struct SeriesTree;
using SeriesTreePointer = std::shared_ptr<const SeriesTree>;
using SeriesTrees = std::vector<SeriesTreePointer>;

/// A vertex with its branches.
struct SeriesTree {
    std::optional<End> above;   ///< its end of the edge above it; none where it is the middle
    SeriesTrees children;       ///< sorted by their text
    int arrows = 0;             ///< counts the arrow above the vertex
    std::int64_t symmetry = 1;  ///< the number of automorphisms
    std::string text;           ///< for example `q[link[q,q],p]`
};

/// The kinds of vertices in the trees of a system.
enum class SeriesFamily {
    general,  ///< any vertices, with arrows only
    nystrom,  ///< for T = p^T K p/2 + U(q): derivatives by q alone, or two at most by p
    linked,   ///< links too, without derivatives by p beyond the second
};

/// Returns the tree of a vertex and its branches, in any order.
[[nodiscard]] SeriesTreePointer graft(std::optional<End> above, SeriesTrees children);

/// Returns all trees of a family, each once, by their number of arrows.
///
/// There are finitely many: vertices with links alone have three or more, so that there is an arrow
/// behind a link. A tree is written from its middle, at which no branch has half of the ends of
/// arrows or more. Where an edge has one half on either side, the middle is the vertex on an
/// arrow's q, or either vertex on a link.
class UnrootedTrees {
public:
    /// Decides whether all trees with a branch vanish; such branches are left out.
    using IsNothing = std::function<bool(const SeriesTree&)>;

    UnrootedTrees(SeriesFamily family, IsNothing is_nothing)
        : family_(family), is_nothing_(std::move(is_nothing)) {}

    /// Returns the trees without arrows, then at each call the trees with one arrow more. Throws
    /// TooLarge where there are too many; then there are no further trees.
    [[nodiscard]] SeriesTrees next();

private:
    void add_branches(End above, int arrows);
    void append_around_vertex(SeriesTrees& trees, int arrows) const;
    void append_around_link(SeriesTrees& trees, int arrows) const;

    SeriesFamily family_;
    IsNothing is_nothing_;
    int next_ = 0;              ///< the arrows of the next trees
    int arrows_of_branch_ = 0;  ///< the arrows of the last branches
    SeriesTrees branches_;      ///< by ascending number of arrows
};

}  // namespace hvi::gen
