// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "generator/exact/methods/trees.hpp"

using namespace hvi::gen;

namespace {

using Counts = std::vector<std::int64_t>;

/// The tree of a text, whose vertices may be in any order.
TreePointer tree(const std::string& text, std::size_t& at) {
    const Colour root = text.at(at++) == 'f' ? Colour::f : Colour::g;
    std::vector<TreePointer> children;
    if (at < text.size() && text[at] == '[') {
        do { children.push_back(tree(text, ++at)); } while (text.at(at) == ',');
        ++at;
    }
    return graft(root, children);
}

TreePointer tree(const std::string& text) {
    std::size_t at = 0;
    return tree(text, at);
}

Counts sizes(const std::vector<std::vector<TreePointer>>& levels) {
    Counts result;
    for (const auto& level : levels) { result.push_back(static_cast<std::int64_t>(level.size())); }
    return result;
}

std::int64_t factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

bool alternates(const Tree& tree) {
    for (const TreePointer& child : tree.children) {
        if (child->root == tree.root || !alternates(*child)) { return false; }
    }
    return true;
}

bool is_linear_in_p(const Tree& tree) {
    if (tree.root == Colour::f && tree.children.size() > 1) { return false; }
    for (const TreePointer& child : tree.children) {
        if (!is_linear_in_p(*child)) { return false; }
    }
    return true;
}

}  // namespace

TEST_CASE("there are as many trees as the books say") {
    // https://oeis.org/A000151, and twice https://oeis.org/A000081
    const Counts general{2, 4, 14, 52, 214, 916, 4116, 18996};
    const Counts separable{2, 2, 4, 8, 18, 40, 96, 230};
    CHECK(sizes(trees(TreeFamily::general, 8)) == general);
    CHECK(sizes(trees(TreeFamily::separable, 8)) == separable);
    CHECK(tree_counts(TreeFamily::general, 8) == general);
    CHECK(tree_counts(TreeFamily::separable, 8) == separable);
    CHECK(tree_counts(TreeFamily::nystrom, 9) == sizes(trees(TreeFamily::nystrom, 9)));
    CHECK(tree_counts(TreeFamily::general, 11).back() == 2119904);
}

TEST_CASE("each tree of a family is there once") {
    const auto all = trees(TreeFamily::general, 6);
    for (std::size_t n = 0; n < all.size(); ++n) {
        std::map<TreeFamily, std::vector<std::string>> expected;
        std::set<std::string> texts;
        for (const TreePointer& tree : all[n]) {
            CHECK(tree->vertices == static_cast<int>(n) + 1);
            texts.insert(tree->text);
            if (!alternates(*tree)) { continue; }
            expected[TreeFamily::separable].push_back(tree->text);
            if (is_linear_in_p(*tree)) { expected[TreeFamily::nystrom].push_back(tree->text); }
        }
        CHECK(texts.size() == all[n].size());
        for (const TreeFamily family : {TreeFamily::separable, TreeFamily::nystrom}) {
            const auto levels = trees(family, 6);
            std::vector<std::string> found;
            for (const TreePointer& tree : levels[n]) { found.push_back(tree->text); }
            CHECK(found == expected[family]);
        }
    }
}

TEST_CASE("density and symmetry are those of the books") {
    struct Known {
        std::string text;
        std::int64_t density, symmetry;
    };
    // Butcher, Numerical Methods for Ordinary Differential Equations, Table 301(I)
    for (const Known& known : std::initializer_list<Known>{{"f", 1, 1},
                                                           {"f[f]", 2, 1},
                                                           {"f[f,f]", 3, 2},
                                                           {"f[f[f]]", 6, 1},
                                                           {"f[f,f,f]", 4, 6},
                                                           {"f[f,f[f]]", 8, 1},
                                                           {"f[f[f,f]]", 12, 2},
                                                           {"f[f[f[f]]]", 24, 1},
                                                           {"f[f[f],f[f]]", 20, 2},
                                                           {"f[f,f,f[f]]", 10, 2},
                                                           {"f[f,f[f,f]]", 15, 2},
                                                           {"f[f,g]", 3, 1},
                                                           {"f[g[g,g],g[g,g]]", 63, 8}}) {
        CAPTURE(known.text);
        CHECK(tree(known.text)->density == known.density);
        CHECK(tree(known.text)->symmetry == known.symmetry);
    }
}

TEST_CASE("the children's order is not part of a tree") {
    CHECK(tree("f[g,f[f]]")->text == "f[f[f],g]");
    CHECK(tree("g[g[f,g],f,g[g,f]]")->text == "g[f,g[f,g],g[f,g]]");
    CHECK(tree("g[g[f,g],f,g[g,f]]")->symmetry == 2);
}

// The labelled trees of n vertices with increasing labels, coloured in any way, are (n-1)! 2^n, and
// a tree has n!/(gamma sigma) of these labellings.
TEST_CASE("the trees account for all increasing labellings") {
    const auto all = trees(TreeFamily::general, 8);
    for (int n = 1; n <= 8; ++n) {
        std::int64_t labellings = 0;
        for (const TreePointer& tree : all[static_cast<std::size_t>(n) - 1]) {
            labellings += factorial(n) / (tree->density * tree->symmetry);
        }
        CHECK(labellings == factorial(n - 1) * (std::int64_t{1} << n));
    }
}
