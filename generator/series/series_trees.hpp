// The trees without a root that the discrete Hamiltonians are sums over.
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

/// What one vertex has of an edge to another: of an arrow the p at its beginning or the q where it
/// ends, or one of the two equal ends of a link.
enum class End { p, q, link };

/// At the other side of the edge.
[[nodiscard]] End other(End end);

struct SeriesTree;
using SeriesTreePointer = std::shared_ptr<const SeriesTree>;
using SeriesTrees = std::vector<SeriesTreePointer>;

/// A vertex with what hangs on it.
struct SeriesTree {
    std::optional<End> above;   ///< its end of the edge above it; none where it is the middle
    SeriesTrees children;       ///< sorted by their text
    int arrows = 0;             ///< with that above it
    std::int64_t symmetry = 1;  ///< the number of automorphisms
    std::string text;           ///< `p`, `q[link[q,q],p]`
};

/// The vertices that a system has.
enum class SeriesFamily {
    general,  ///< with arrows alone, any
    nystrom,  ///< for T = p^T K p/2 + U(q): derivatives by q alone, or two at most by p
    linked,   ///< with links too, but for a derivative by p that is not above the second
};

/// The tree of a vertex and what hangs on it, in any order.
[[nodiscard]] SeriesTreePointer graft(std::optional<End> above, SeriesTrees children);

/// All trees of a family, each once, by their number of arrows.
///
/// There are finitely many: vertices with links alone have three or more, so that behind a link
/// there is an arrow. A tree is written from its middle, which is found by the ends of arrows: no
/// branch of it has half of them or more. Where an edge has one half on either side, that is the
/// vertex on an arrow's q, or either one on a link.
class UnrootedTrees {
public:
    /// Whether a branch says nothing, whatever it hangs on: then it is left out.
    using IsNothing = std::function<bool(const SeriesTree&)>;

    UnrootedTrees(SeriesFamily family, IsNothing is_nothing)
        : family_(family), is_nothing_(std::move(is_nothing)) {}

    /// Those with no arrow, and with one more each time. Throws TooLarge where there are too many;
    /// then there are no next ones.
    [[nodiscard]] SeriesTrees next();

private:
    void add_branches(End above, int arrows);
    void append_around_vertex(SeriesTrees& trees, int arrows) const;
    void append_around_link(SeriesTrees& trees, int arrows) const;

    SeriesFamily family_;
    IsNothing is_nothing_;
    int next_ = 0;              ///< the arrows of the next trees
    int arrows_of_branch_ = 0;  ///< of the last branches
    SeriesTrees branches_;      ///< by ascending number of arrows
};

}  // namespace hvi::gen
