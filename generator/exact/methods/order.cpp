// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/order.hpp"

#include <memory>
#include <utility>

#include "generator/exact/methods/polynomial_stages.hpp"
#include "generator/exact/methods/projected_stages.hpp"
#include "generator/exact/methods/tree_conditions.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Thrown where enclosures are too wide for a decision.
struct TooWide {};

/// Returns psi of tree_classes.hpp, for one tree.
BallStages::Function psi(const BallStages& stages, const Tree& tree) {
    BallStages::Function result = stages.one();
    for (const TreePointer& child : tree.children) {
        const auto chi = stages.apply(child->root, psi(stages, *child), child->vertices);
        result = stages.product(result, chi);
    }
    return result;
}

/// Decides whether a condition holds by an enclosure of its defect.
Verdict decided(const Ball& defect) {
    const auto verdict = vanishes(defect);
    if (!verdict) { throw TooWide(); }
    return *verdict;
}

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

template <class Stages, class Decide, class ToNumber>
Orders examine(const Stages& stages, Decide decide, ToNumber to_number, int max_order) {
    const Progress::Stage stage("checking order conditions");
    HVI_CHECK(max_order >= 1 && max_order <= most_vertices);
    const auto of = [&](TreeFamily family) {
        return conditions::examine(stages, decide, to_number, family, max_order);
    };
    return {of(TreeFamily::general), of(TreeFamily::separable), of(TreeFamily::nystrom)};
}

/// Calls `examine` with the stages, in exact arithmetic where the numbers allow it.
template <class Examine>
auto on_stages(const PartitionedMethod& method, Examine examine) {
    if (method.is_exact()) {
        try {
            return examine(NumberStages(method), conditions::Exactly(), conditions::ExactDefect());
        } catch (const TooLarge&) {
            if (method.has_parameters()) { throw; }
        }
    }
    const EnclosedDefect to_number(method);
    // NOTE: enclosures of zero narrower than 10^-50 take 167 bits and some more for cancellation.
    for (Precision bits = 4 * first_precision; bits <= last_precision; bits *= 2) {
        try {
            return examine(BallStages(method, bits), decided, to_number);
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
        return examine(PolynomialStages(*P), conditions::Exactly(), conditions::ExactDefect(),
                       max_order);
    }
    if (tableau.galerkin && !tableau.parameters.empty()) {
        const GalerkinStages stages(tableau, *tableau.galerkin);
        return examine(stages, conditions::Exactly(), conditions::ExactDefect(), max_order);
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
        return conditions::examine(ProjectedStages(*rule.over_rationals), conditions::Exactly(),
                                   conditions::ExactDefect(), TreeFamily::nystrom, max_order);
    }
    return on_stages(
        partitioned_method(rule), [&](const auto& stages, auto decide, auto to_number) {
            return conditions::examine(stages, decide, to_number, TreeFamily::nystrom, max_order);
        });
}

Orders orders(const RoundedMethod& method, int max_order) {
    return examine(RoundedStages(method), can_be_zero, EnclosedDefect(method.written), max_order);
}

}  // namespace hvi::gen
