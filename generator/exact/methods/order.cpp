// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/order.hpp"

#include <map>
#include <memory>
#include <utility>

#include "generator/exact/methods/polynomial_stages.hpp"
#include "generator/exact/methods/projected_stages.hpp"
#include "generator/exact/methods/tree_classes.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Thrown where enclosures are too wide for a decision.
struct TooWide {};

Verdict is_zero(const Number& number) { return {number.is_zero(), true}; }
Verdict is_zero(const RationalPolynomial& constant) { return {constant.degree() < 0, true}; }
Verdict is_zero(const Ball& ball) {
    const auto verdict = vanishes(ball);
    if (!verdict) { throw TooWide(); }
    return *verdict;
}

Number rational_defect(const RationalPolynomial& constant, const TreePointer& /*tree*/) {
    fmpq_t value;
    fmpq_init(value);
    fmpq_poly_get_coeff_fmpq(value, constant.get(), 0);
    Number result = number(Element::copy_of(value), nullptr);
    fmpq_clear(value);
    return result;
}

/// Returns psi of tree_classes.hpp, for one tree.
BallStages::Function psi(const BallStages& stages, const Tree& tree) {
    BallStages::Function result = stages.one();
    for (const TreePointer& child : tree.children) {
        const auto chi = stages.apply(child->root, psi(stages, *child), child->vertices);
        result = stages.product(result, chi);
    }
    return result;
}

/// Decides whether a condition holds, by its defect.
struct Decided {
    template <class Scalar>
    Verdict operator()(const Scalar& defect) const {
        return is_zero(defect);
    }
};

Number exact_defect(const Number& defect, const TreePointer& /*tree*/) { return defect; }

/// Returns whether a defect can be zero, for coefficients that are known to some digits only.
Verdict can_be_zero(const Ball& defect) {
    return defect.sign() == 0 ? Verdict{true, false} : Verdict{false, true};
}

/// The defect gamma sum_i b_i Phi_i - 1, enclosed to any precision anew from the coefficients.
/// NOTE: there may be thousands of defects, which share the method.
class EnclosedDefect {
public:
    explicit EnclosedDefect(const PartitionedMethod& method)
        : method_(std::make_shared<const PartitionedMethod>(method)) {}

    Number operator()(const Ball& /*defect*/, const TreePointer& tree) const {
        return number(Real([method = method_, tree](Precision bits) {
            const BallStages stages(*method, bits);
            return stages.defect(tree->root, psi(stages, *tree), tree->vertices);
        }));
    }

private:
    std::shared_ptr<const PartitionedMethod> method_;
};

/// Returns the sum of the terms. NOTE: in pairs, pairs of pairs and so on: a number known by its
/// enclosures remembers its terms, and thousands of terms in a chain would take more stack than
/// there is.
Number sum_of(NumberVector terms) {
    if (terms.empty()) { return Number(0); }
    for (; terms.size() > 1; terms.resize((terms.size() + 1) / 2)) {
        for (std::size_t i = 0; 2 * i + 1 < terms.size(); ++i) {
            terms[i] = terms[2 * i] + terms[2 * i + 1];
        }
        if (terms.size() % 2 == 1) { terms[terms.size() / 2] = terms.back(); }
    }
    return terms.front();
}

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

template <class Stages, class Decide, class ToNumber>
Orders examine(const Stages& stages, Decide decide, ToNumber to_number, int max_order) {
    const Progress::Stage stage("checking order conditions");
    HVI_CHECK(max_order >= 1 && max_order <= most_vertices);
    return {examine(stages, decide, to_number, TreeFamily::general, max_order),
            examine(stages, decide, to_number, TreeFamily::separable, max_order),
            examine(stages, decide, to_number, TreeFamily::nystrom, max_order)};
}

/// Calls `examine` with the stages, in exact arithmetic where the numbers allow it.
template <class Examine>
auto on_stages(const PartitionedMethod& method, Examine examine) {
    if (method.is_exact()) {
        try {
            return examine(NumberStages(method), Decided(), exact_defect);
        } catch (const TooLarge&) {
            if (method.has_parameters()) { throw; }
        }
    }
    const EnclosedDefect to_number(method);
    // NOTE: enclosures of zero narrower than 10^-50 take 167 bits and some more for cancellation.
    for (Precision bits = 4 * first_precision; bits <= last_precision; bits *= 2) {
        try {
            return examine(BallStages(method, bits), Decided(), to_number);
        } catch (const TooWide&) { continue; }
    }
    throw MathError("cannot decide whether an order condition holds with " +
                    std::to_string(last_precision) + " bits");
}

}  // namespace

std::optional<Number> OrderConditions::error_constant() const {
    if (!error_constant_squared) { return {}; }
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
    if (const RationalPolynomial* const P = tableau.node_polynomial()) {
        return examine(PolynomialStages(*P), Decided(), rational_defect, max_order);
    }
    if (tableau.galerkin && !tableau.parameters.empty()) {
        const GalerkinStages stages(tableau, *tableau.galerkin);
        return examine(stages, Decided(), exact_defect, max_order);
    }
    return orders(partitioned_method(tableau), max_order);
}

Orders orders(const PartitionedMethod& method, int max_order) {
    return on_stages(method, [&](const auto& stages, auto decide, auto to_number) {
        return examine(stages, decide, to_number, max_order);
    });
}

OrderConditions nystrom_order(const GalerkinRule& rule, int max_order) {
    const Progress::Stage stage("checking order conditions");
    HVI_CHECK(max_order >= 1 && max_order <= most_vertices);
    if (rule.over_rationals) {
        return examine(ProjectedStages(*rule.over_rationals), Decided(), rational_defect,
                       TreeFamily::nystrom, max_order);
    }
    return on_stages(partitioned_method(rule),
                     [&](const auto& stages, auto decide, auto to_number) {
                         return examine(stages, decide, to_number, TreeFamily::nystrom, max_order);
                     });
}

Orders orders(const RoundedMethod& method, int max_order) {
    return examine(RoundedStages(method), can_be_zero, EnclosedDefect(method.written), max_order);
}

}  // namespace hvi::gen
