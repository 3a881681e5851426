// Conditions on trees, class by class, in the arithmetic of any stages.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/exact/methods/order.hpp"
#include "generator/exact/methods/tree_classes.hpp"

namespace hvi::gen::conditions {

[[nodiscard]] inline Verdict is_zero(const Number& number) { return {number.is_zero(), true}; }
[[nodiscard]] inline Verdict is_zero(const RationalPolynomial& constant) {
    return {constant.degree() < 0, true};
}

/// Return a scalar of exact stages as a number.
[[nodiscard]] inline Number to_number(const Number& scalar) { return scalar; }
[[nodiscard]] Number to_number(const RationalPolynomial& constant);

/// Decides whether a condition holds by its defect, in exact arithmetic.
struct Exactly {
    template <class Scalar>
    [[nodiscard]] Verdict operator()(const Scalar& defect) const {
        return is_zero(defect);
    }
};

/// Returns the defect of a tree as a number, in exact arithmetic.
struct ExactDefect {
    template <class Scalar>
    [[nodiscard]] Number operator()(const Scalar& defect, const TreePointer& /*tree*/) const {
        return to_number(defect);
    }
};

/// Returns the sum of the terms. NOTE: in pairs, pairs of pairs and so on: a number known by its
/// enclosures remembers its terms, and thousands of terms in a chain would take more stack than
/// there is.
[[nodiscard]] Number sum_of(NumberVector terms);

/// Classes of trees that violate their condition, with their gamma sum_i b_i Phi_i - 1.
using FailedClasses = std::map<std::pair<Colour, std::size_t>, Number>;

/// Returns the failed classes among the last trees. `to_number` takes a defect as the stages
/// compute it, and a tree that has it.
template <class Stages, class Decide, class ToNumber>
FailedClasses failed_classes(const Stages& stages, const TreeClasses<Stages>& classes,
                             Decide decide, ToNumber to_number, bool& proved) {
    FailedClasses failed;
    for (const Colour root : {Colour::f, Colour::g}) {
        const auto& values = classes.values(root);
        for (std::size_t number = 0; number < values.size(); ++number) {
            const auto defect = stages.defect(root, values[number], classes.vertices());
            const Verdict verdict = decide(defect);
            if (!verdict.holds) {
                const TreePointer tree = classes.representative(root, number);
                failed.emplace(std::pair(root, number), to_number(defect, tree));
            }
            proved = proved && verdict.proved;
        }
    }
    return failed;
}

/// Failures of one class: trees of one root and one gamma sum_i b_i Phi_i - 1, the defect. NOTE:
/// there are many, and most of them share their computations.
class FailedClass {
public:
    explicit FailedClass(const Number& defect) : defect_(defect) {}

    FailedCondition add(const TreePointer& tree) {
        ++counts_[tree->density * tree->symmetry];
        const auto [entry, is_new] = residuals_.try_emplace(tree->density);
        if (is_new) { entry->second = defect_ / Number(tree->density); }
        return {tree, entry->second};
    }

    /// Returns the sum of (residual/sigma)^2.
    [[nodiscard]] Number squares() const {
        Number sum;
        for (const auto& [product, count] : counts_) {
            sum = sum + Number(count) / (Number(product) * Number(product));
        }
        return defect_ * defect_ * sum;
    }

private:
    Number defect_;
    std::map<std::int64_t, std::int64_t> counts_;  ///< number of trees by gamma sigma
    std::map<std::int64_t, Number> residuals_;     ///< by gamma
};

/// Lists the failures of all trees in failed classes, and sets the error constant.
template <class Classes>
void list_failures(OrderConditions& result, const FailedClasses& failed, Classes& classes,
                   TreeFamily family) {
    std::map<std::pair<Colour, std::size_t>, FailedClass> failures;
    for (const auto& [place, defect] : failed) { failures.emplace(place, defect); }
    const auto all_trees = trees(family, classes.vertices());
    for (const TreePointer& tree : all_trees.back()) {
        const auto found = failures.find({tree->root, classes.class_of(*tree)});
        if (found != failures.end()) { result.failures.push_back(found->second.add(tree)); }
    }
    NumberVector squares;
    for (const auto& [place, trees] : failures) {
        if (failed.at(place).has_parameters()) { return; }
        squares.push_back(trees.squares());
    }
    result.error_constant_squared = sum_of(std::move(squares));
}

template <class Classes>
void list_representatives(OrderConditions& result, const FailedClasses& failed,
                          const Classes& classes) {
    for (const auto& [place, defect] : failed) {
        const TreePointer tree = classes.representative(place.first, place.second);
        result.failures.push_back({tree, defect / Number(tree->density)});
    }
    std::sort(result.failures.begin(), result.failures.end(),
              [](const FailedCondition& left, const FailedCondition& right) {
                  return comes_before(left.tree, right.tree);
              });
}

/// Checks the conditions of order 1, 2, ..., `max_order` until some fail; see orders().
template <class Stages, class Decide, class ToNumber>
OrderConditions examine(const Stages& stages, Decide decide, ToNumber to_number, TreeFamily family,
                        int max_order) {
    constexpr std::size_t most_values =
        300'000;  // at the stages; the next ones are five times more
    TreeClasses classes(stages, family);
    OrderConditions result;
    FailedClasses failed;
    std::size_t values = 0;
    while (failed.empty() && classes.vertices() < max_order && values <= most_values) {
        classes.grow();
        values = classes.size() * static_cast<std::size_t>(stages.count());
        failed = failed_classes(stages, classes, decide, to_number, result.proved);
    }
    result.is_at_least = failed.empty();
    result.order = classes.vertices() - (failed.empty() ? 0 : 1);
    result.conditions = tree_counts(family, classes.vertices());
    if (classes.vertices() > OrderConditions::most_listed_vertices) {
        list_representatives(result, failed, classes);
    } else if (!failed.empty()) {
        list_failures(result, failed, classes, family);
    }
    return result;
}

}  // namespace hvi::gen::conditions
