// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/trees.hpp"

#include <algorithm>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

std::string text(Colour root, const std::vector<TreePointer>& children) {
    std::string result(1, root == Colour::f ? 'f' : 'g');
    for (std::size_t i = 0; i < children.size(); ++i) {
        result += (i == 0 ? "[" : ",") + children[i]->text;
    }
    return children.empty() ? result : result + "]";
}

}  // namespace

bool comes_before(const TreePointer& left, const TreePointer& right) {
    if (left == right || left->root != right->root) { return left->root < right->root; }
    return std::lexicographical_compare(left->children.begin(), left->children.end(),
                                        right->children.begin(), right->children.end(),
                                        comes_before);
}

TreePointer graft(Colour root, std::vector<TreePointer> children) {
    std::sort(children.begin(), children.end(), comes_before);
    Tree tree;
    tree.root = root;
    std::int64_t equal = 0;  // number of equal last children
    for (std::size_t i = 0; i < children.size(); ++i) {
        const Tree& child = *children[i];
        equal = i != 0 && child.text == children[i - 1]->text ? equal + 1 : 1;
        tree.vertices += child.vertices;
        tree.density *= child.density;
        tree.symmetry *= child.symmetry * equal;
    }
    HVI_CHECK(tree.vertices <= most_vertices);
    tree.density *= tree.vertices;
    tree.text = text(root, children);
    tree.children = std::move(children);
    return std::make_shared<const Tree>(std::move(tree));
}

std::vector<Kind> kinds(TreeFamily family) {
    constexpr std::size_t any = most_vertices;
    if (family == TreeFamily::general) { return {{{Colour::f, Colour::g}, 0, any}}; }
    return {{{Colour::f}, 1, family == TreeFamily::nystrom ? 1 : any}, {{Colour::g}, 0, any}};
}

void for_each_multiset(const std::vector<int>& sizes, int total, std::size_t most_items,
                       const std::function<void(const std::vector<std::size_t>&)>& visit) {
    std::vector<std::size_t> chosen;
    const std::function<void(std::size_t, int)> choose = [&](std::size_t first, int left) {
        if (left == 0) { visit(chosen); }
        if (left == 0 || chosen.size() == most_items) { return; }
        for (std::size_t i = first; i < sizes.size() && sizes[i] <= left; ++i) {
            // NOTE: with an item of this size, the rest is empty or holds items that are no
            // smaller.
            if (sizes[i] != left && 2 * sizes[i] > left) { continue; }
            chosen.push_back(i);
            choose(i, left - sizes[i]);
            chosen.pop_back();
        }
    };
    choose(0, total);
}

std::vector<std::vector<TreePointer>> trees(TreeFamily family, int vertices) {
    const std::vector<Kind> all_kinds = kinds(family);
    std::vector<std::vector<TreePointer>> of_kind(all_kinds.size());
    std::vector<std::vector<int>> sizes(all_kinds.size());
    std::vector<std::vector<TreePointer>> result;
    for (int n = 1; n <= vertices; ++n) {
        std::vector<TreePointer> level;
        for (const Kind& kind : all_kinds) {
            const std::vector<TreePointer>& from = of_kind[kind.children];
            const auto add = [&](const std::vector<std::size_t>& chosen) {
                std::vector<TreePointer> children;
                for (const std::size_t i : chosen) { children.push_back(from[i]); }
                for (const Colour root : kind.roots) { level.push_back(graft(root, children)); }
            };
            for_each_multiset(sizes[kind.children], n - 1, kind.most_children, add);
        }
        std::sort(level.begin(), level.end(), comes_before);
        for (const TreePointer& tree : level) {
            const std::size_t kind = all_kinds.size() == 1 || tree->root == Colour::f ? 0 : 1;
            of_kind[kind].push_back(tree);
            sizes[kind].push_back(n);
        }
        result.push_back(std::move(level));
    }
    return result;
}

std::vector<std::int64_t> tree_counts(TreeFamily family, int vertices) {
    HVI_CHECK(vertices <= most_vertices);
    const auto n = static_cast<std::size_t>(vertices);
    const std::vector<Kind> all_kinds = kinds(family);
    // roots[k][m]: trees of kind k with m vertices; forests[k][m]: multisets of them with m
    // vertices in all, sum_m forests[m] x^m = product_i (1 - x^i)^(-roots[i]), and so m forests[m]
    // = sum_i (sum over the divisors d of i of d roots[d]) forests[m - i].
    std::vector<std::vector<std::int64_t>> roots(all_kinds.size(),
                                                 std::vector<std::int64_t>(n + 1, 0));
    auto forests = roots;
    auto sums = roots;
    std::vector<std::int64_t> result;
    for (std::size_t m = 0; m < n; ++m) {
        std::int64_t total = 0;
        for (std::size_t k = 0; k < all_kinds.size(); ++k) {
            for (std::size_t i = 1; i <= m; ++i) {
                forests[k][m] += sums[k][i] * forests[k][m - i];
            }
            forests[k][m] = m == 0 ? 1 : forests[k][m] / static_cast<std::int64_t>(m);
        }
        for (std::size_t k = 0; k < all_kinds.size(); ++k) {
            const Kind& kind = all_kinds[k];
            const bool single = kind.most_children == 1 && m != 0;
            const std::int64_t carried =
                single ? roots[kind.children][m] : forests[kind.children][m];
            roots[k][m + 1] = carried * static_cast<std::int64_t>(kind.roots.size());
            total += roots[k][m + 1];
        }
        for (std::size_t k = 0; k < all_kinds.size(); ++k) {
            for (std::size_t i = m + 1; i <= n; i += m + 1) {
                sums[k][i] += static_cast<std::int64_t>(m + 1) * roots[k][m + 1];
            }
        }
        result.push_back(total);
    }
    return result;
}

}  // namespace hvi::gen
