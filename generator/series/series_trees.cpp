// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/series_trees.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "generator/exact/methods/trees.hpp"
#include "generator/exact/numbers/budget.hpp"

namespace hvi::gen {

namespace {

/// The limit: a longer sum takes too long.
constexpr std::size_t most_trees = 500'000;

/// A kind of vertices with these ends, at most so many.
struct VertexKind {
    std::vector<End> ends;
    std::size_t most_edges;

    [[nodiscard]] bool has(End end) const {
        return std::find(ends.begin(), ends.end(), end) != ends.end();
    }
};

/// Returns the kinds. They have no edges in common, so that a vertex has one kind.
std::vector<VertexKind> vertex_kinds(SeriesFamily family) {
    constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
    switch (family) {
    case SeriesFamily::general: return {{{End::p, End::q}, any}};
    case SeriesFamily::nystrom: return {{{End::q}, any}, {{End::p}, 2}};
    case SeriesFamily::linked: break;
    }
    return {{{End::p, End::q, End::link}, any}};
}

const char* name(End end) {
    switch (end) {
    case End::p: return "p";
    case End::q: return "q";
    case End::link: break;
    }
    return "link";
}

std::string text(std::optional<End> above, const SeriesTrees& children) {
    std::string result = above ? name(*above) : "";
    for (std::size_t i = 0; i < children.size(); ++i) {
        result += (i == 0 ? "[" : ",") + children[i]->text;
    }
    return children.empty() ? result : result + "]";
}

/// Whether a vertex vanishes. NOTE: on a link the part in the span vanishes, as do 1 and d2H/dp2
/// times the value of an arrow. Two links and nothing else are a part of d2H/dp2, whose inverse
/// links have.
bool is_second_derivative_with_link(std::optional<End> above, const SeriesTrees& children) {
    std::vector<End> ends;
    if (above) { ends.push_back(*above); }
    for (const SeriesTreePointer& child : children) { ends.push_back(other(*child->above)); }
    const auto has = [&](End end) { return std::count(ends.begin(), ends.end(), end) != 0; };
    return ends.size() <= 2 && has(End::link) && !has(End::q);
}

int ends_of_arrows(const SeriesTree& branch) {
    return 2 * branch.arrows - (branch.above == End::link ? 0 : 1);
}

/// Calls `add` with the children of each vertex of this kind that has `arrows` arrows below.
template <class Add>
void for_each_vertex(const SeriesTrees& candidates, int arrows, std::size_t most, const Add& add) {
    std::vector<int> sizes;
    for (const SeriesTreePointer& branch : candidates) { sizes.push_back(branch->arrows); }
    for_each_multiset(sizes, arrows, most, [&](const std::vector<std::size_t>& chosen) {
        SeriesTrees children;
        for (const std::size_t i : chosen) { children.push_back(candidates[i]); }
        add(std::move(children));
    });
}

void append(SeriesTrees& trees, SeriesTreePointer tree) {
    if (trees.size() == most_trees) { throw TooLarge(); }
    trees.push_back(std::move(tree));
}

}  // namespace

End other(End end) {
    switch (end) {
    case End::p: return End::q;
    case End::q: return End::p;
    case End::link: break;
    }
    return End::link;
}

SeriesTreePointer graft(std::optional<End> above, SeriesTrees children) {
    std::sort(children.begin(), children.end(),
              [](const auto& left, const auto& right) { return left->text < right->text; });
    SeriesTree tree;
    tree.above = above;
    tree.arrows = above && *above != End::link ? 1 : 0;
    std::int64_t equal = 0;  // how many of the last children are equal
    for (std::size_t i = 0; i < children.size(); ++i) {
        const SeriesTree& child = *children[i];
        equal = i != 0 && child.text == children[i - 1]->text ? equal + 1 : 1;
        tree.arrows += child.arrows;
        tree.symmetry *= child.symmetry * equal;
    }
    tree.text = text(above, children);
    tree.children = std::move(children);
    return std::make_shared<const SeriesTree>(std::move(tree));
}

SeriesTrees UnrootedTrees::next() {
    const int arrows = next_++;
    if (arrows == 0) { return {graft(std::nullopt, {})}; }
    while (2 * arrows_of_branch_ < arrows) {
        ++arrows_of_branch_;
        // NOTE: links come last, since below a link there are only arrows, and as many as it has.
        for (const End above : {End::p, End::q, End::link}) {
            add_branches(above, arrows_of_branch_);
        }
    }
    SeriesTrees result;
    append_around_vertex(result, arrows);
    append_around_link(result, arrows);
    return result;
}

void UnrootedTrees::add_branches(End above, int arrows) {
    SeriesTrees found;
    for (const VertexKind& kind : vertex_kinds(family_)) {
        if (!kind.has(above)) { continue; }
        SeriesTrees candidates;
        for (const SeriesTreePointer& branch : branches_) {
            if (kind.has(other(*branch->above))) { candidates.push_back(branch); }
        }
        const int below = above == End::link ? arrows : arrows - 1;
        for_each_vertex(candidates, below, kind.most_edges - 1, [&](SeriesTrees children) {
            if (is_second_derivative_with_link(above, children)) { return; }
            auto branch = graft(above, std::move(children));
            if (!is_nothing_(*branch)) { append(found, std::move(branch)); }
        });
    }
    branches_.insert(branches_.end(), found.begin(), found.end());
}

void UnrootedTrees::append_around_vertex(SeriesTrees& trees, int arrows) const {
    for (const VertexKind& kind : vertex_kinds(family_)) {
        SeriesTrees candidates;
        for (const SeriesTreePointer& branch : branches_) {
            const int half = branch->above == End::p ? arrows : arrows - 1;
            if (kind.has(other(*branch->above)) && ends_of_arrows(*branch) <= half) {
                candidates.push_back(branch);
            }
        }
        for_each_vertex(candidates, arrows, kind.most_edges, [&](SeriesTrees children) {
            if (is_second_derivative_with_link(std::nullopt, children)) { return; }
            append(trees, graft(std::nullopt, std::move(children)));
        });
    }
}

/// NOTE: where both halves are equal, swapping them is one more automorphism.
void UnrootedTrees::append_around_link(SeriesTrees& trees, int arrows) const {
    SeriesTrees halves;
    for (const SeriesTreePointer& branch : branches_) {
        if (branch->above == End::link && ends_of_arrows(*branch) == arrows) {
            halves.push_back(branch);
        }
    }
    for (std::size_t i = 0; i < halves.size(); ++i) {
        for (std::size_t j = i; j < halves.size(); ++j) {
            SeriesTrees children = halves[i]->children;
            children.push_back(halves[j]);
            SeriesTree tree = *graft(std::nullopt, std::move(children));
            if (i == j) { tree.symmetry *= 2; }
            append(trees, std::make_shared<const SeriesTree>(std::move(tree)));
        }
    }
}

}  // namespace hvi::gen
