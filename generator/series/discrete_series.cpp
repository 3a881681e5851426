// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/discrete_series.hpp"

#include <map>
#include <string>
#include <utility>

#include "generator/exact/numbers/budget.hpp"
#include "generator/lower/system.hpp"
#include "generator/read/names.hpp"
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
struct Coefficients {
    Number exact;
    Number difference;  ///< that of the method less the exact one
};

class Series {
public:
    Series(const Tableau& tableau, const Hamiltonian& hamiltonian, const Ground& ground)
        : hamiltonian_(with_values(hamiltonian)),
          exact_(exact_weight(ground)),
          method_(method_weight(tableau, ground)),
          elementary_(system_of(hamiltonian, parameter_names(hamiltonian)), ground) {}

    /// That of h, which is H: by constants in the span of the basis the sum of all weights is 1
    /// (Leok & Zhang, Section 4.4.3). NOTE: as it is written, and so however long it is.
    void begin(DiscreteSeries& result) const;
    void append(DiscreteSeries& result, const std::vector<TreePointer>& trees);

private:
    [[nodiscard]] Coefficients coefficients(const std::vector<TreePointer>& trees);
    [[nodiscard]] Expression written(const Number& number) const;
    void compare(DiscreteSeries& result, const Number& difference) const;
    [[nodiscard]] bool is_proved_nonzero(const Expression& difference) const;

    Expression hamiltonian_;
    TreeWeight exact_, method_;
    ElementaryHamiltonians elementary_;
};

void Series::begin(DiscreteSeries& result) const {
    HVI_CHECK(method_(*graft(Colour::f, {})).is_one());
    result.exact.push_back(hamiltonian_);
    result.method.push_back(hamiltonian_);
}

void Series::append(DiscreteSeries& result, const std::vector<TreePointer>& trees) {
    const Coefficients found = coefficients(trees);
    result.exact.push_back(written(found.exact));
    result.method.push_back(found.difference.is_zero() ? result.exact.back()
                                                       : written(found.exact + found.difference));
    if (!result.first_difference && !result.undecided) { compare(result, found.difference); }
}

/// NOTE: a tree whose weights agree adds nothing to the difference, whatever H is.
Coefficients Series::coefficients(const std::vector<TreePointer>& trees) {
    Coefficients result;
    for (const TreePointer& tree : trees) {
        const Number value = elementary_(*tree);
        if (value.is_zero()) { continue; }
        const Number share = value / Number(static_cast<long>(tree->symmetry));
        const Number weight = exact_(*tree);
        const Number excess = method_(*tree) - weight;
        result.exact = result.exact + weight * share;
        if (!excess.is_zero()) { result.difference = result.difference + excess * share; }
    }
    return result;
}

Expression Series::written(const Number& number) const {
    const auto form = number.closed_form();
    if (!form) { throw TooLarge(); }
    return substituted(*form, elementary_.values().hidden());
}

void Series::compare(DiscreteSeries& result, const Number& difference) const {
    if (difference.is_zero()) { return; }
    const int power = static_cast<int>(result.exact.size());
    Expression form = written(difference);
    if (!elementary_.values().hidden().empty() && !is_proved_nonzero(form)) {
        result.undecided = power;
        return;
    }
    result.first_difference = power;
    result.difference = std::move(form);
}

/// At some rational points: where functions may depend on each other in ways that the normal form
/// does not see, a value that is not zero is a proof.
bool Series::is_proved_nonzero(const Expression& difference) const {
    constexpr int points = 4;
    for (int point = 0; point < points; ++point) {
        SymbolValues values;
        walk(difference, [&](const Expression& part) {
            if (part.kind == Expression::Kind::symbol) {
                const std::size_t count = values.size();
                const std::string above = std::to_string(31 + 7 * point + 11 * count);
                values.try_emplace(part.name, ball_of_rational(above + "/97", first_precision));
            }
            return true;
        });
        try {
            const Ball value = value_at(difference, values, nullptr);
            if (arb_is_finite(value.get()) != 0 && value.sign() != 0) { return true; }
        } catch (const MathError&) { continue; }  // no value there
    }
    return false;
}

[[noreturn]] void refuse_length(const Hamiltonian& hamiltonian, std::size_t power) {
    throw MathError("the terms of h^" + std::to_string(power) +
                        " for this H are too long to be computed",
                    Place{hamiltonian.source, hamiltonian.expression.range},
                    "--series " + std::to_string(power - 1) + " is computed");
}

}  // namespace

DiscreteSeries discrete_series(const Tableau& tableau, const Hamiltonian& hamiltonian, int terms,
                               const Ground& ground) {
    const Progress::Stage stage("computing the series of the discrete Hamiltonians");
    Series series(tableau, hamiltonian, ground);
    DiscreteSeries result;
    series.begin(result);
    const auto trees = unrooted_trees(terms);
    try {
        for (std::size_t k = 1; k < trees.size(); ++k) { series.append(result, trees[k]); }
    } catch (const TooLarge&) { refuse_length(hamiltonian, result.exact.size() + 1); }
    return result;
}

}  // namespace hvi::gen
