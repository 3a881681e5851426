// Trees sorted by the values of their elementary weights, so that each value is computed once.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "generator/exact/methods/trees.hpp"

namespace hvi::gen {

/// Trees of a family with 1, 2, ... vertices. With Phi_i(tau) the product over the children c of
/// sum_j a_ij Phi_j(c) (a~_ij for a child g), a tree tau of n vertices has
///
///     psi(tau) = gamma(tau) Phi(tau) / n = product over the children of chi(c),
///     chi(tau) = n A psi(tau)   (A~ for a root g)
///
/// as functions on the stages, and its order condition sum_i b_i Phi_i = 1/gamma is n b.psi = 1.
/// Where the stages are of order n, A psi = x^n/n, all trees have psi = x^(n-1). Trees with one psi
/// are a class, and trees with one chi a branch, whatever their shapes are.
///
/// `Stages` provides the arithmetic: NumberStages, BallStages or PolynomialStages.
template <class Stages>
class TreeClasses {
public:
    using Function = typename Stages::Function;

    TreeClasses(const Stages& stages, TreeFamily family)
        : stages_(stages),
          kinds_(kinds(family)),
          generations_(kinds_.size()),
          branches_(kinds_.size()) {}

    /// Returns the number of vertices of the last trees.
    [[nodiscard]] int vertices() const { return static_cast<int>(generations_[0].size()); }

    /// Returns the number of classes of the last trees.
    [[nodiscard]] std::size_t size() const {
        std::size_t result = 0;
        for (const auto& generations : generations_) { result += generations.back().values.size(); }
        return result;
    }

    /// Goes on to trees with one vertex more.
    void grow() {
        if (vertices() != 0) { add_branches(); }
        std::vector<Generation> next;
        for (const Kind& kind : kinds_) { next.push_back(generation(kind, vertices() + 1)); }
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            generations_[k].push_back(std::move(next[k]));
        }
    }

    /// Returns psi by class, for the last trees with a root of this colour.
    [[nodiscard]] const std::vector<Function>& values(Colour root) const {
        return generations_[kind_of(root)].back().values;
    }

    /// Returns a tree of this colour and class among the last ones.
    [[nodiscard]] TreePointer representative(Colour root, std::size_t number) const {
        return representative({vertices(), root, number});
    }

    /// Returns the class of one of the last trees.
    [[nodiscard]] std::size_t class_of(const Tree& tree) { return place(tree); }

private:
    using Multiset = std::vector<std::size_t>;  ///< of branches, ascending

    /// Trees of one kind and one number of vertices.
    struct Generation {
        std::vector<Function> values;
        std::vector<Multiset> children;  ///< of the first tree of a class
        std::map<Multiset, std::size_t> numbers;
        std::vector<std::array<std::size_t, 2>> branches;  ///< by class and colour
    };
    struct Origin {
        int vertices;
        Colour root;
        std::size_t number;
    };
    struct Branches {
        std::vector<Function> values;
        std::vector<int> sizes;
        std::vector<Origin> origins;  ///< the first
    };

    /// Products of functions; neighbours share a beginning.
    class Products {
    public:
        Products(const Stages& stages, const std::vector<Function>& factors)
            : stages_(stages), factors_(factors) {}

        const Function& of(const Multiset& chosen) {
            std::size_t common = 0;
            while (common < std::min(chosen.size(), chosen_.size()) &&
                   chosen[common] == chosen_[common]) {
                ++common;
            }
            partial_.resize(common + 1, partial_.front());
            for (std::size_t i = common; i < chosen.size(); ++i) {
                const Function& factor = factors_[chosen[i]];
                partial_.push_back(i == 0 ? factor : stages_.product(partial_.back(), factor));
            }
            chosen_ = chosen;
            return partial_.back();
        }

    private:
        const Stages& stages_;
        const std::vector<Function>& factors_;
        Multiset chosen_;
        std::vector<Function> partial_{stages_.one()};
    };

    [[nodiscard]] std::size_t kind_of(Colour root) const {
        return kinds_.size() == 1 || root == Colour::f ? 0 : 1;
    }

    [[nodiscard]] Generation generation(const Kind& kind, int n) const {
        const Branches& from = branches_[kind.children];
        Generation result;
        std::map<Function, std::size_t, typename Stages::Less> known;
        Products products(stages_, from.values);
        for_each_multiset(from.sizes, n - 1, kind.most_children, [&](const Multiset& children) {
            const Function& psi = products.of(children);
            const auto [entry, is_new] = known.emplace(psi, result.values.size());
            if (is_new) {
                result.values.push_back(psi);
                result.children.push_back(children);
            }
            result.numbers.emplace(children, entry->second);
        });
        return result;
    }

    void add_branches() {
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            Generation& last = generations_[k].back();
            last.branches.resize(last.values.size());
            std::map<Function, std::size_t, typename Stages::Less> known;
            for (std::size_t number = 0; number < last.values.size(); ++number) {
                for (const Colour root : kinds_[k].roots) {
                    Function chi = stages_.apply(root, last.values[number], vertices());
                    const auto [entry, is_new] = known.emplace(chi, branches_[k].values.size());
                    last.branches[number][static_cast<std::size_t>(root)] = entry->second;
                    if (!is_new) { continue; }
                    branches_[k].values.push_back(std::move(chi));
                    branches_[k].sizes.push_back(vertices());
                    branches_[k].origins.push_back({vertices(), root, number});
                }
            }
        }
    }

    [[nodiscard]] TreePointer representative(const Origin& origin) const {
        const std::size_t k = kind_of(origin.root);
        const Generation& trees = generations_[k][static_cast<std::size_t>(origin.vertices) - 1];
        std::vector<TreePointer> children;
        for (const std::size_t branch : trees.children[origin.number]) {
            children.push_back(representative(branches_[kinds_[k].children].origins[branch]));
        }
        return graft(origin.root, std::move(children));
    }

    std::size_t place(const Tree& tree) {
        Multiset children;
        for (const TreePointer& child : tree.children) { children.push_back(branch(*child)); }
        std::sort(children.begin(), children.end());
        return generation_of(tree).numbers.at(children);
    }

    std::size_t branch(const Tree& tree) {
        const auto known = branch_of_tree_.find(&tree);
        if (known != branch_of_tree_.end()) { return known->second; }
        const std::size_t result =
            generation_of(tree).branches[place(tree)][static_cast<std::size_t>(tree.root)];
        branch_of_tree_.emplace(&tree, result);
        return result;
    }

    [[nodiscard]] const Generation& generation_of(const Tree& tree) const {
        return generations_[kind_of(tree.root)][static_cast<std::size_t>(tree.vertices) - 1];
    }

    const Stages& stages_;
    std::vector<Kind> kinds_;
    std::vector<std::vector<Generation>> generations_;  ///< by kind and number of vertices
    std::vector<Branches> branches_;                    ///< by kind
    std::unordered_map<const Tree*, std::size_t> branch_of_tree_;
};

}  // namespace hvi::gen
