// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/order.hpp"

#include <map>

#include "generator/exact/number_value.hpp"
#include "generator/exact/polynomial_stages.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/tree_classes.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Enclosures were too wide for a decision.
struct TooWide {};

Verdict is_zero(const Number& number) { return {number.is_zero(), true}; }
Verdict is_zero(const RationalPolynomial& constant) { return {constant.degree() < 0, true}; }
Verdict is_zero(const Ball& ball) {
    const auto verdict = vanishes(ball);
    if (!verdict) { throw TooWide(); }
    return *verdict;
}

Number constant_term(const RationalPolynomial& polynomial) {
    fmpq_t value;
    fmpq_init(value);
    fmpq_poly_get_coeff_fmpq(value, polynomial.get(), 0);
    Number result = number(Element::copy_of(value), nullptr);
    fmpq_clear(value);
    return result;
}

/// psi of tree_classes.hpp, for one tree.
BallStages::Function psi(const BallStages& stages, const Tree& tree) {
    BallStages::Function result = stages.one();
    for (const TreePointer& child : tree.children) {
        const auto chi = stages.apply(child->root, psi(stages, *child), child->vertices);
        result = stages.product(result, chi);
    }
    return result;
}

/// gamma sum_i b_i Phi_i - 1, enclosed to any precision anew from the coefficients.
Number enclosed_defect(const PartitionedMethod& method, const TreePointer& tree) {
    return number(Real([method, tree](Precision bits) {
        const BallStages stages(method, bits);
        return stages.defect(tree->root, psi(stages, *tree), tree->vertices);
    }));
}

/// Classes of trees that violate their condition, and gamma sum_i b_i Phi_i - 1 for them.
using FailedClasses = std::map<std::pair<Colour, std::size_t>, Number>;

/// Among the last trees. `to_number` takes such a defect as the stages compute it, and a tree that
/// has it.
template <class Stages, class ToNumber>
FailedClasses failed_classes(const Stages& stages, const TreeClasses<Stages>& classes,
                             ToNumber to_number, bool& proved) {
    FailedClasses failed;
    for (const Colour root : {Colour::f, Colour::g}) {
        const auto& values = classes.values(root);
        for (std::size_t number = 0; number < values.size(); ++number) {
            const auto defect = stages.defect(root, values[number], classes.vertices());
            const Verdict verdict = is_zero(defect);
            if (!verdict.holds) {
                const TreePointer tree = classes.representative(root, number);
                failed.emplace(std::pair(root, number), to_number(defect, tree));
            }
            proved = proved && verdict.proved;
        }
    }
    return failed;
}

/// The failures of one class: trees of one root and one gamma sum_i b_i Phi_i - 1, the defect.
/// NOTE: they are many, and what there is to compute is the same for most of them.
class FailedClass {
public:
    explicit FailedClass(const Number& defect) : defect_(defect) {}

    FailedCondition add(const TreePointer& tree) {
        ++counts_[tree->density * tree->symmetry];
        const auto [entry, is_new] = residuals_.try_emplace(tree->density);
        if (is_new) { entry->second = defect_ / Number(tree->density); }
        return {tree, entry->second};
    }

    /// The sum of (residual/sigma)^2.
    [[nodiscard]] Number squares() const {
        Number sum;
        for (const auto& [product, count] : counts_) {
            sum = sum + Number(count) / (Number(product) * Number(product));
        }
        return defect_ * defect_ * sum;
    }

private:
    Number defect_;
    std::map<std::int64_t, std::int64_t> counts_;  ///< of trees by gamma sigma
    std::map<std::int64_t, Number> residuals_;     ///< by gamma
};

/// Those of all trees in failed classes, and the error constant.
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
    Number squares;
    for (const auto& [place, trees] : failures) { squares = squares + trees.squares(); }
    result.error_constant_squared = squares;
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

template <class Stages, class ToNumber>
OrderConditions examine(const Stages& stages, ToNumber to_number, TreeFamily family,
                        int max_order) {
    TreeClasses classes(stages, family);
    OrderConditions result;
    FailedClasses failed;
    while (failed.empty() && classes.vertices() < max_order) {
        classes.grow();
        failed = failed_classes(stages, classes, to_number, result.proved);
    }
    result.is_at_least = failed.empty();
    result.order = failed.empty() ? max_order : classes.vertices() - 1;
    result.conditions = tree_counts(family, classes.vertices());
    if (classes.vertices() > OrderConditions::most_listed_vertices) {
        list_representatives(result, failed, classes);
    } else if (!failed.empty()) {
        list_failures(result, failed, classes, family);
    }
    return result;
}

template <class Stages, class ToNumber>
Orders examine(const Stages& stages, ToNumber to_number, int max_order) {
    const Progress::Stage stage("checking order conditions");
    HVI_CHECK(max_order >= 1 && max_order <= most_vertices);
    return {examine(stages, to_number, TreeFamily::general, max_order),
            examine(stages, to_number, TreeFamily::separable, max_order),
            examine(stages, to_number, TreeFamily::nystrom, max_order)};
}

}  // namespace

std::optional<Number> OrderConditions::error_constant() const {
    if (!error_constant_squared || error_constant_squared->has_parameters()) { return {}; }
    if (const auto rational = rational_text(*error_constant_squared)) {
        const Ground ground(std::make_shared<Field>(Denominators{}));
        return ground.sqrt(ground.rational(*rational, "1"));
    }
    return number(Real([square = *error_constant_squared](Precision bits) {
        Ball result = enclosure(square, bits);
        arb_sqrtpos(result.get(), result.get(), bits);
        return result;
    }));
}

Orders orders(const Tableau& tableau, int max_order) {
    if (!tableau.node_polynomial) { return orders(partitioned_method(tableau), max_order); }
    const auto to_number = [](const RationalPolynomial& defect, const TreePointer&) {
        return constant_term(defect);
    };
    return examine(PolynomialStages(*tableau.node_polynomial), to_number, max_order);
}

Orders orders(const PartitionedMethod& method, int max_order) {
    if (method.is_exact()) {
        const auto to_number = [](const Number& defect, const TreePointer&) { return defect; };
        return examine(NumberStages(method), to_number, max_order);
    }
    const auto to_number = [&](const Ball&, const TreePointer& tree) {
        return enclosed_defect(method, tree);
    };
    // NOTE: enclosures of zero narrower than 10^-50 take 167 bits and some more for what is lost.
    for (Precision bits = 4 * first_precision; bits <= last_precision; bits *= 2) {
        try {
            return examine(BallStages(method, bits), to_number, max_order);
        } catch (const TooWide&) { continue; }
    }
    throw MathError("cannot decide whether an order condition holds with " +
                    std::to_string(last_precision) + " bits");
}

}  // namespace hvi::gen
