// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/step_equations.hpp"

#include <algorithm>
#include <utility>

#include "generator/equations/quadratic.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/linear/generating_function.hpp"
#include "generator/linear/one_step_map.hpp"

namespace hvi::gen {

namespace {

/// Written out by powers of h. Precondition: a number of the field.
Expression written(const Number& number) {
    auto form = number.expanded_form("h");
    HVI_CHECK(form.has_value());
    return *std::move(form);
}

MapEquations equations(const LinearMap& map) {
    MapEquations result;
    for (const NumberVector& row : map.matrix) {
        result.matrix.emplace_back();
        for (const Number& entry : row) result.matrix.back().push_back(written(entry));
    }
    for (const Number& entry : map.offset) result.offset.push_back(written(entry));
    return result;
}

/// x^T S x/2 + g^T x + constant, term by term, in the variables' names.
Expression polynomial(const QuadraticForm& form, const std::vector<std::string>& names) {
    std::vector<Expression> terms;
    const auto append = [&](const Number& coefficient, std::vector<Expression> variables) {
        if (coefficient.is_zero()) return;
        const Expression factor = written(coefficient);
        if (variables.empty() || !(factor == Expression::integer(1)))
            variables.insert(variables.begin(), factor);
        terms.push_back(Expression::product(std::move(variables)));
    };
    const auto x = [&](std::size_t i) { return Expression::symbol(names[i]); };
    for (std::size_t i = 0; i < names.size(); ++i) {
        append(form.S[i][i] / Number(2), {Expression::power(x(i), Expression::integer(2))});
        for (std::size_t j = i + 1; j < names.size(); ++j) append(form.S[i][j], {x(i), x(j)});
    }
    for (std::size_t i = 0; i < names.size(); ++i) append(form.g[i], {x(i)});
    append(form.constant, {});
    return Expression::sum(std::move(terms));
}

GeneratingEquations equations(const GeneratingFunction& function,
                              const std::vector<std::string>& names) {
    GeneratingEquations result;
    result.discrete = polynomial(function.discrete, names);
    if (function.exact) result.exact = polynomial(*function.exact, names);
    result.gives_map = function.gives_map;
    result.is_symmetric = function.is_symmetric;
    result.order_of_difference = function.order_of_difference;
    result.is_at_least = function.is_at_least;
    return result;
}

bool has_closed_form(const Tableau& tableau) {
    const auto is_closed = [](const NumberVector& row) {
        return std::all_of(row.begin(), row.end(), is_exact);
    };
    return tableau.node_polynomial() != nullptr ||
           (is_closed(tableau.b) && std::all_of(tableau.A.begin(), tableau.A.end(), is_closed) &&
            std::all_of(tableau.A_tilde.begin(), tableau.A_tilde.end(), is_closed));
}

[[noreturn]] void refuse_generating(const Hamiltonian& hamiltonian, const std::string& obstacle) {
    const std::string help = "leave out --generating for the equations of the stages";
    if (depends_on_time(hamiltonian))
        throw MathError("the generating function has a closed form only where H does not depend on "
                        "the time `t`",
                        Place{hamiltonian.source, hamiltonian.expression.range}, help);
    throw MathError("the generating function has a closed form for quadratic Hamiltonians only",
                    Place{hamiltonian.source, hamiltonian.expression.range},
                    obstacle.empty() ? help : obstacle + "; " + help);
}

/// With the map, and H_d^+ where it is wished; or with the equations of the stages.
void add_equations(StepEquations& step, const Tableau& tableau, const Hamiltonian& hamiltonian,
                   const Ground& ground, bool generating) {
    // NOTE: first, since it refuses with their places what has no value or is too long.
    const Gradient slopes = gradient(hamiltonian);
    const QuadraticProof proof = quadratic_form(hamiltonian, ground);
    step.obstacle = proof.obstacle;
    if (proof.form && !has_closed_form(tableau))
        step.obstacle = "the coefficients of the method have no closed form";
    if (!proof.form || !step.obstacle.empty()) {
        if (generating) refuse_generating(hamiltonian, step.obstacle);
        step.stages = stage_equations(tableau, hamiltonian, slopes);
        return;
    }
    step.map = equations(one_step_map(tableau, *proof.form, ground));
    if (generating)
        step.generating =
            equations(generating_function(tableau, *proof.form, ground), variables(hamiltonian));
}

/// Of the general Galerkin form the series are built alone.
[[noreturn]] void refuse_equations(const Method& method) {
    throw InputError("of the general Galerkin form (4.6), with more nodes than functions, the "
                     "series are built alone; its equations are to come",
                     whole(method.nodes.source),
                     "give as many nodes as basis functions, or --series N without --generating");
}

}  // namespace

std::vector<std::string> variables(const StepEquations& step) {
    std::vector<std::string> names = step.coordinates;
    names.insert(names.end(), step.momenta.begin(), step.momenta.end());
    return names;
}

StepEquations step_equations(const Method& method, const Hamiltonian& hamiltonian, bool generating,
                             std::optional<int> series) {
    StepEquations step;
    static_cast<StepTitle&>(step) = title_of(method, hamiltonian);
    step.hamiltonian = hamiltonian.expression;
    step.coordinates = hamiltonian.coordinates;
    step.momenta = hamiltonian.momenta;
    return on_new_ground([&](const Ground& ground) {
        StepEquations result = step;
        const AnyDerivation derived = derive_any_on(ground, method);
        if (const auto* const tableau = std::get_if<Tableau>(&derived.method)) {
            add_equations(result, *tableau, hamiltonian, derived.ground, generating);
        } else if (generating || !series) {
            refuse_equations(method);
        }
        if (series)
            result.series = discrete_series(derived.method, hamiltonian, *series, derived.ground);
        return result;
    });
}

}  // namespace hvi::gen
