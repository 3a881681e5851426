// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/discrete_series.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>

#include "generator/exact/numbers/budget.hpp"
#include "generator/lower/system.hpp"
#include "generator/scene/value_at.hpp"
#include "generator/series/elementary_hamiltonians.hpp"
#include "generator/series/tree_weights.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using Expressions = std::map<std::string, Expression>;

/// Replaces symbols by expressions.
Expression substituted(const Expression& expression, const Expressions& symbols) {
    if (expression.kind == Expression::Kind::symbol) {
        const auto found = symbols.find(expression.name);
        return found == symbols.end() ? expression : found->second;
    }
    std::vector<Expression> arguments;
    for (const Expression& argument : expression.arguments) {
        arguments.push_back(substituted(argument, symbols));
    }
    return with_arguments(expression, std::move(arguments));
}

/// Returns H as it was written, with values of parameters put in.
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
    Number difference;  ///< the method's coefficient less the exact one
    Expression difference_form;
};

const std::vector<std::string>& parameters(const DerivedMethod& method) {
    return std::visit(
        [](const auto& derived) -> const auto& { return derived.parameters; }, method);
}

/// Returns a point with a different rational number for each symbol, and for each `point`. NOTE:
/// none is a binary fraction, so that all their balls have a radius, and a ball that is exactly 0
/// belongs to a function that is 0 everywhere.
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

/// Proves that functions are not zero, by their values at a point.
class AtPoint {
public:
    AtPoint(const System& system, SymbolValues point)
        : point_(std::move(point)), elementary_(system, point_) {}

    /// Decides for the sum of excess/symmetry times the elementary Hamiltonian.
    [[nodiscard]] bool
    is_proved_nonzero(const std::vector<std::pair<SeriesTreePointer, Expression>>& excesses) {
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

/// Returns the kind of systems for which a method has weights.
SeriesFamily family_of(const DerivedMethod& method, const System& system) {
    if (std::holds_alternative<Tableau>(method)) { return SeriesFamily::general; }
    const bool is_nystrom = system.structure.kinetic_is_quadratic;
    return is_nystrom ? SeriesFamily::nystrom : SeriesFamily::linked;
}

class Series {
public:
    Series(const DerivedMethod& method, const Hamiltonian& hamiltonian, const System& system,
           const Ground& ground)
        : hamiltonian_(with_values(hamiltonian)),
          exact_(exact_weight(ground)),
          method_(method_weight(method, ground)),
          trees_(family_of(method, system),
                 [this](const SeriesTree& branch) {
                     return exact_->is_nothing(branch) && method_->is_nothing(branch);
                 }),
          elementary_(system, ground),
          points_{
              {{system, some_point(system, method, 0)}, {system, some_point(system, method, 1)}}} {}
    Series(const Series&) = delete;
    Series& operator=(const Series&) = delete;

    /// Appends the coefficient of h, which is H: with constants in the span of the basis the sum of
    /// all weights is 1 (Leok & Zhang, Section 4.4.3). NOTE: H is taken as it is written, and so
    /// has any length.
    void begin(DiscreteSeries& result);
    void append(DiscreteSeries& result);

private:
    [[nodiscard]] std::optional<SeriesTrees> next_trees();
    [[nodiscard]] std::optional<Forms> forms(const SeriesTrees& trees);
    [[nodiscard]] Expression written(const Number& number) const;
    void compare(DiscreteSeries& result, const std::optional<SeriesTrees>& trees,
                 const std::optional<Forms>& found);
    [[nodiscard]] std::optional<bool> are_equal(const std::optional<SeriesTrees>& trees);

    Expression hamiltonian_;
    TreeWeightPointer exact_, method_;
    UnrootedTrees trees_;
    bool are_too_many_ = false;
    ElementaryHamiltonians<NodeValues> elementary_;
    std::array<AtPoint, 2> points_;
};

void Series::begin(DiscreteSeries& result) {
    HVI_CHECK((*method_)(*trees_.next().front()).is_one());
    result.exact.emplace_back(hamiltonian_);
    result.method.emplace_back(hamiltonian_);
}

/// NOTE: after a coefficient that is too long all are.
void Series::append(DiscreteSeries& result) {
    const auto trees = next_trees();
    const auto found = trees && result.exact.back() ? forms(*trees) : std::nullopt;
    result.exact.push_back(found ? std::optional(found->exact) : std::nullopt);
    result.method.push_back(found ? std::optional(found->method) : std::nullopt);
    if (!result.first_difference && !result.undecided) { compare(result, trees, found); }
}

/// Returns nothing where there are too many trees, and from then on.
std::optional<SeriesTrees> Series::next_trees() {
    if (are_too_many_) { return std::nullopt; }
    try {
        return trees_.next();
    } catch (const TooLarge&) {
        are_too_many_ = true;
        return std::nullopt;
    }
}

/// NOTE: a tree with equal weights adds nothing to the difference, for any H.
std::optional<Forms> Series::forms(const SeriesTrees& trees) {
    Number exact, difference;
    try {
        for (const SeriesTreePointer& tree : trees) {
            const Number weight = (*exact_)(*tree);
            const Number excess = (*method_)(*tree) - weight;
            if (weight.is_zero() && excess.is_zero()) { continue; }
            const Number value = elementary_(*tree);
            if (value.is_zero()) { continue; }
            const Number share = value / Number(static_cast<long>(tree->symmetry));
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

/// Compares two coefficients by the normal form, if functions in it cannot depend on each other in
/// ways that it does not see; else by the weights of trees and by values.
void Series::compare(DiscreteSeries& result, const std::optional<SeriesTrees>& trees,
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

/// Whether the coefficients are equal, if that is proved or refuted.
std::optional<bool> Series::are_equal(const std::optional<SeriesTrees>& trees) {
    if (!trees) { return std::nullopt; }
    std::vector<std::pair<SeriesTreePointer, Expression>> excesses;
    for (const SeriesTreePointer& tree : *trees) {
        const Number excess = (*method_)(*tree) - (*exact_)(*tree);
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

void check_smooth(const Hamiltonian& hamiltonian, const System& system) {
    std::vector<Scaled> slopes = by_coordinates(system);
    const std::vector<Scaled> by_p = by_conjugates(system);
    slopes.insert(slopes.end(), by_p.begin(), by_p.end());
    slopes.push_back(function_of(system));
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
    Series series(method, hamiltonian, system, ground);
    DiscreteSeries result;
    series.begin(result);
    for (int k = 1; k < terms; ++k) { series.append(result); }
    return result;
}

}  // namespace hvi::gen
