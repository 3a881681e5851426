// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/discrete_series.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>

#include "generator/exact/numbers/budget.hpp"
#include "generator/lower/kinetic_rank.hpp"
#include "generator/lower/system.hpp"
#include "generator/scene/value_at.hpp"
#include "generator/series/elementary_hamiltonians.hpp"
#include "generator/series/tree_weights.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using Expressions = std::map<std::string, Expression>;

/// With expressions in place of symbols.
Expression substituted(const Expression& expression, const Expressions& symbols) {
    using Kind = Expression::Kind;
    if (expression.kind == Kind::symbol) {
        const auto found = symbols.find(expression.name);
        return found == symbols.end() ? expression : found->second;
    }
    std::vector<Expression> arguments;
    for (const Expression& argument : expression.arguments) {
        arguments.push_back(substituted(argument, symbols));
    }
    if (expression.kind == Kind::sum) { return Expression::sum(std::move(arguments)); }
    if (expression.kind == Kind::product) { return Expression::product(std::move(arguments)); }
    Expression result = expression;
    result.arguments = std::move(arguments);
    return result;
}

/// H as it was written, but for parameters that have a value.
Expression with_values(const Hamiltonian& hamiltonian) {
    Expressions values;
    for (const Parameter& parameter : hamiltonian.parameters) {
        values.emplace(parameter.name, parameter.value);
    }
    return substituted(hamiltonian.expression, values);
}

/// The coefficients of one power of h.
struct Forms {
    Expression exact, method;
    Number difference;  ///< that of the method less the exact one
    Expression difference_form;
};

const std::vector<std::string>& parameters(const DerivedMethod& method) {
    return std::visit(
        [](const auto& derived) -> const auto& { return derived.parameters; }, method);
}

/// All symbols, each at a rational number of its own; at others in each point. NOTE: none is a
/// binary fraction, so that all their balls have a radius, and a ball that is 0 is that of a
/// function that is 0 everywhere.
SymbolValues some_point(const System& system, const DerivedMethod& method, std::size_t point) {
    SymbolValues values;
    const auto add = [&](const std::string& name) {
        const std::size_t third = 31 + 7 * point + 11 * values.size();
        values.try_emplace(
            name, ball_of_rational(std::to_string(3 * third + 1) + "/291", first_precision));
    };
    for (Node node = 0; node < system.graph.size(); ++node) {
        const Computation& computation = system.graph.at(node);
        if (computation.operation == Operation::input) { add(computation.name); }
    }
    for (const std::string& name : parameters(method)) { add(name); }
    return values;
}

/// What is not zero, by its value at a point, where a value that is not zero is a proof.
class AtPoint {
public:
    AtPoint(const System& system, SymbolValues point)
        : point_(std::move(point)), elementary_(system, point_) {}

    /// sum of excess/symmetry times the elementary Hamiltonian.
    [[nodiscard]] bool
    is_proved_nonzero(const std::vector<std::pair<TreePointer, Expression>>& excesses) {
        Ball sum = NodeBalls::integer(0);
        for (const auto& [tree, excess] : excesses) {
            Ball share = NodeBalls::product(value_at(excess, point_, nullptr), elementary_(*tree));
            arb_div_si(share.get(), share.get(), tree->symmetry, first_precision);
            sum = NodeBalls::sum(sum, share);
        }
        return arb_is_finite(sum.get()) != 0 && sum.sign() != 0;
    }

private:
    SymbolValues point_;
    ElementaryHamiltonians<NodeBalls> elementary_;
};

class Series {
public:
    Series(const DerivedMethod& method, const Hamiltonian& hamiltonian, const System& system,
           const Ground& ground)
        : hamiltonian_(with_values(hamiltonian)),
          exact_(exact_weight(ground)),
          method_(method_weight(method, ground)),
          elementary_(system, ground),
          points_{
              {{system, some_point(system, method, 0)}, {system, some_point(system, method, 1)}}} {}

    /// That of h, which is H: by constants in the span of the basis the sum of all weights is 1
    /// (Leok & Zhang, Section 4.4.3). NOTE: as it is written, and so however long it is.
    void begin(DiscreteSeries& result) const;
    void append(DiscreteSeries& result, const std::vector<TreePointer>& trees);

private:
    [[nodiscard]] std::optional<Forms> forms(const std::vector<TreePointer>& trees);
    [[nodiscard]] Expression written(const Number& number) const;
    void compare(DiscreteSeries& result, const std::vector<TreePointer>& trees,
                 const std::optional<Forms>& found);
    [[nodiscard]] std::optional<bool> are_equal(const std::vector<TreePointer>& trees);

    Expression hamiltonian_;
    TreeWeight exact_, method_;
    ElementaryHamiltonians<NodeValues> elementary_;
    std::array<AtPoint, 2> points_;
};

void Series::begin(DiscreteSeries& result) const {
    HVI_CHECK(method_(*graft(Colour::f, {})).is_one());
    result.exact.emplace_back(hamiltonian_);
    result.method.emplace_back(hamiltonian_);
}

/// NOTE: beyond a coefficient that is too long all are.
void Series::append(DiscreteSeries& result, const std::vector<TreePointer>& trees) {
    const auto found = result.exact.back() ? forms(trees) : std::nullopt;
    result.exact.push_back(found ? std::optional(found->exact) : std::nullopt);
    result.method.push_back(found ? std::optional(found->method) : std::nullopt);
    if (!result.first_difference && !result.undecided) { compare(result, trees, found); }
}

/// NOTE: a tree whose weights agree adds nothing to the difference, whatever H is.
std::optional<Forms> Series::forms(const std::vector<TreePointer>& trees) {
    Number exact, difference;
    try {
        for (const TreePointer& tree : trees) {
            const Number value = elementary_(*tree);
            if (value.is_zero()) { continue; }
            const Number share = value / Number(static_cast<long>(tree->symmetry));
            const Number weight = exact_(*tree);
            const Number excess = method_(*tree) - weight;
            exact = exact + weight * share;
            if (!excess.is_zero()) { difference = difference + excess * share; }
        }
        return Forms{written(exact), written(exact + difference), difference, written(difference)};
    } catch (const TooLarge&) { return std::nullopt; }
}

Expression Series::written(const Number& number) const {
    const auto form = number.closed_form();
    if (!form) { throw TooLarge(); }
    return substituted(*form, elementary_.values().hidden());
}

/// By the normal form, where the functions in it cannot depend on each other in ways that it does
/// not see; else by the weights of trees and by values.
void Series::compare(DiscreteSeries& result, const std::vector<TreePointer>& trees,
                     const std::optional<Forms>& found) {
    const bool is_zero = found && found->difference.is_zero();
    const bool decides = found && (is_zero || elementary_.values().hidden().empty());
    const auto equal = decides ? std::optional(is_zero) : are_equal(trees);
    const int power = static_cast<int>(result.exact.size());
    if (!equal) { result.undecided = power; }
    if (!equal.value_or(true)) {
        result.first_difference = power;
        if (found) { result.difference = found->difference_form; }
    }
}

/// Whether the coefficients are, where that is proved.
std::optional<bool> Series::are_equal(const std::vector<TreePointer>& trees) {
    std::vector<std::pair<TreePointer, Expression>> excesses;
    for (const TreePointer& tree : trees) {
        const Number excess = method_(*tree) - exact_(*tree);
        const auto form = excess.closed_form();
        if (!form) { return std::nullopt; }
        if (!excess.is_zero()) { excesses.emplace_back(tree, *form); }
    }
    if (excesses.empty()) { return true; }
    for (AtPoint& point : points_) {
        try {
            if (point.is_proved_nonzero(excesses)) { return false; }
        } catch (const MathError&) { continue; }  // no value there, or too long
    }
    return std::nullopt;
}

/// The systems for which a method has weights.
TreeFamily family_of(const DerivedMethod& method) {
    return std::holds_alternative<GalerkinRule>(method) ? TreeFamily::nystrom : TreeFamily::general;
}

void check_quadratic_kinetic(const Hamiltonian& hamiltonian, const System& system) {
    const Place place{hamiltonian.source, hamiltonian.expression.range};
    if (!system.structure.kinetic_is_quadratic) {
        throw InputError("series of the general Galerkin form are built for H = p^T K p/2 + U(q) "
                         "alone; others are to come",
                         place, "take as many nodes as functions");
    }
    check_kinetic_rank(system, place);
}

void check_smooth(const Hamiltonian& hamiltonian, const System& system) {
    std::vector<Scaled> slopes = system.dHdq;
    slopes.insert(slopes.end(), system.dHdp.begin(), system.dHdp.end());
    slopes.push_back(system.hamiltonian);
    if (!has_kinks(system.graph, slopes)) { return; }
    throw MathError("the series have derivatives of H of all orders, and H is not smooth",
                    Place{hamiltonian.source, hamiltonian.expression.range},
                    "abs, sign, min, max and if have kinks; leave out --series");
}

}  // namespace

DiscreteSeries discrete_series(const DerivedMethod& method, const Hamiltonian& hamiltonian,
                               int terms, const Ground& ground) {
    const Progress::Stage stage("computing the series of the discrete Hamiltonians");
    const System system = system_of(hamiltonian, parameter_names(hamiltonian));
    check_smooth(hamiltonian, system);
    const TreeFamily family = family_of(method);
    if (family == TreeFamily::nystrom) { check_quadratic_kinetic(hamiltonian, system); }
    Series series(method, hamiltonian, system, ground);
    DiscreteSeries result;
    series.begin(result);
    const auto trees = unrooted_trees(family, terms);
    for (std::size_t k = 1; k < trees.size(); ++k) { series.append(result, trees[k]); }
    return result;
}

}  // namespace hvi::gen
