// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/step_equations.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/equations/quadratic.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/exact/numbers/budget.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/hamiltonian/fibre_rank.hpp"
#include "generator/linear/generating_function.hpp"
#include "generator/linear/one_step_map.hpp"
#include "generator/lower/system.hpp"

namespace hvi::gen {

namespace {

/// Writes a number out by powers of h. Precondition: it is a number of the field.
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

/// Writes x^T S x/2 + g^T x + constant, term by term, in the variables' names.
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
    result.has_type_one = function.has_type_one;
    result.order_of_difference = function.order_of_difference;
    result.is_at_least = function.is_at_least;
    return result;
}

bool is_closed(const NumberVector& row) { return std::all_of(row.begin(), row.end(), is_exact); }

bool are_closed(const NumberMatrix& rows) {
    return std::all_of(rows.begin(), rows.end(), is_closed);
}

bool has_closed_form(const Tableau& tableau) {
    return tableau.node_polynomial() != nullptr ||
           (is_closed(tableau.b) && are_closed(tableau.A) && are_closed(tableau.A_tilde));
}

bool has_closed_form(const GalerkinRule& rule) {
    return rule.over_rationals != nullptr ||
           (is_closed(rule.b) && are_closed(rule.Psi) && are_closed(rule.A_psi));
}

std::string obstacle_to_map(const QuadraticProof& proof, bool method_has_closed_form) {
    return proof.form && !method_has_closed_form
               ? "the coefficients of the method have no closed form"
               : proof.obstacle;
}

/// Throws MathError where more nodes than functions do not determine the P from the V by (4.6e).
void check_determined(const Hamiltonian& hamiltonian) {
    const Place place{hamiltonian.source, hamiltonian.expression.range};
    const System system = system_of(hamiltonian, parameter_names(hamiltonian));
    if (!is_degenerate(hessian_of(system))) return check_fibre_rank(hamiltonian, place);
    throw MathError("with more nodes than functions (4.6e) determines p at the nodes only where "
                    "d2H/dp2 is regular, and its rank is below the degrees of freedom, as a row of "
                    "it is zero",
                    place, "take as many nodes as functions");
}

/// Wishes beyond the equations.
struct StepWishes {
    bool generating;
    std::optional<int> series;
};

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

/// Adds the map, and H_d^+ where it is wished for.
template <class Method>
void add_map(StepEquations& step, const Method& method, const QuadraticForm& H,
             const Ground& ground, const StepWishes& wishes) {
    step.map = equations(one_step_map(method, H, ground));
    if (wishes.generating)
        step.generating = equations(generating_function(method, H, ground), variables(step));
}

/// Adds the map, or the equations of the stages.
void add_equations(StepEquations& step, const Tableau& tableau, const Ground& ground,
                   const Hamiltonian& hamiltonian, const StepWishes& wishes) {
    // NOTE: the gradient comes first, since it refuses undefined and overlong parts with their
    // places.
    const Gradient slopes = gradient(hamiltonian);
    const QuadraticProof proof = quadratic_form(hamiltonian, ground);
    step.obstacle = obstacle_to_map(proof, has_closed_form(tableau));
    if (proof.form && step.obstacle.empty())
        return add_map(step, tableau, *proof.form, ground, wishes);
    if (wishes.generating) refuse_generating(hamiltonian, step.obstacle);
    step.stages = stage_equations(tableau, hamiltonian, slopes);
}

/// Adds the map of the general form, or (4.6).
void add_equations(StepEquations& step, const GalerkinRule& rule, const Ground& ground,
                   const Hamiltonian& hamiltonian, const StepWishes& wishes) {
    const Gradient slopes = gradient(hamiltonian);
    check_determined(hamiltonian);
    const QuadraticProof proof = quadratic_form(hamiltonian, ground);
    step.basis = rule.provenance.basis;
    step.obstacle = obstacle_to_map(proof, has_closed_form(rule));
    try {
        if (proof.form && step.obstacle.empty())
            return add_map(step, rule, *proof.form, ground, wishes);
    } catch (const TooLarge&) { step.obstacle = "the map is too long to be computed"; }
    if (wishes.generating) refuse_generating(hamiltonian, step.obstacle);
    step.at_nodes = galerkin_equations(rule, hamiltonian, slopes);
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
        const AnyDerivation found = derive_any_on(ground, method);
        std::visit(
            [&](const auto& derived) {
                add_equations(result, derived, found.ground, hamiltonian, {generating, series});
            },
            found.method);
        if (series)
            result.series = discrete_series(found.method, hamiltonian, *series, found.ground);
        return result;
    });
}

}  // namespace hvi::gen
