// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/ingredients.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/functions/factor.hpp"
#include "generator/exact/functions/independence.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Returns the coefficients of the functions and of 1 in the independent terms that occur in them.
NumberMatrix in_terms(const std::vector<BasisFunction>& psi, const ExactFunction& last) {
    std::vector<ExactTerm> shapes;
    NumberMatrix rows;
    const auto append = [&](const ExactFunction& function) {
        NumberVector row(shapes.size());
        for (const ExactTerm& term : function.terms()) {
            std::size_t column = 0;
            while (column < shapes.size() && !same_shape(shapes[column], term)) ++column;
            if (column == shapes.size()) {
                shapes.push_back(term);
                row.emplace_back();
            }
            row[column] = term.coefficient;
        }
        rows.push_back(std::move(row));
    };
    for (const BasisFunction& function : psi) append(function.function);
    append(last);
    for (NumberVector& row : rows) row.resize(shapes.size());
    return rows;
}

bool has_independent_terms(const std::vector<BasisFunction>& psi) {
    for (const BasisFunction& function : psi) {
        for (const ExactTerm& term : function.function.terms()) {
            if (term.factor != nullptr && !is_independent(*term.factor)) return false;
        }
    }
    return true;
}

bool proved_independent_of_one(const std::vector<BasisFunction>& psi) {
    std::vector<ExactFunction> functions{ExactFunction(Number(1))};
    for (const BasisFunction& function : psi) functions.push_back(function.function);
    return proved_independent(functions);
}

/// Returns the result of `work` for a basis function; its errors get the function's place, and
/// `where()`.
template <class Work, class Where>
Number of_function(const BasisFunction& function, Where where, Work work) {
    try {
        return work();
    } catch (const MathError& error) {
        if (error.place()) throw;
        throw MathError(error.what() + where(), function.place, error.help());
    } catch (const InputError& error) {
        if (error.place()) throw;
        throw InputError(error.what() + where(), function.place, error.help());
    }
}

}  // namespace

Ingredients ingredients(const Method& method, Ground ground) {
    for (const Parameter& parameter : method.parameters) {
        ground.set_parameter(parameter.name,
                             evaluate_number(parameter.value, parameter.source, ground));
    }
    Nodes nodes = quadrature_nodes(method.nodes, ground);
    auto psi = basis_functions(method.basis, nodes.c, ground);
    return {std::move(ground), std::move(psi), std::move(nodes)};
}

Provenance provenance(const Method& method, const std::vector<BasisFunction>& psi) {
    Provenance result{method.name, method.origin, {}};
    for (const BasisFunction& function : psi) { result.basis.push_back(function.form); }
    return result;
}

NumberVector given_weights(const Method& method, const Ingredients& given) {
    const List& list = *method.weights;
    if (list.items.size() != given.nodes.c.size()) {
        throw InputError(std::to_string(list.items.size()) + " weights for " +
                             std::to_string(given.nodes.c.size()) + " nodes",
                         whole(list.source), "every node needs a weight of its own");
    }
    NumberVector weights;
    for (const Item& item : list.items) {
        weights.push_back(
            evaluate_number(std::get<Expression>(item.what), list.source, given.ground));
    }
    return weights;
}

std::string text_of(const Number& number) {
    const auto form = number.closed_form();
    return form ? to_text(*form) : number.decimal(16);
}

std::string node_text(const NumberVector& nodes, std::size_t i) {
    return "node " + std::to_string(i + 1) + ", c = " + text_of(nodes[i]);
}

std::string combination_text(const NumberVector& v, const std::vector<BasisFunction>& psi) {
    std::vector<Expression> terms;
    for (std::size_t i = v.size(); i-- > 0;) {
        if (v[i].is_zero()) continue;
        const auto factor = v[i].closed_form();
        if (!factor) return "a combination of the basis functions";
        const bool negative = factor->kind == Expression::Kind::negation;
        const Expression& size = negative ? factor->arguments[0] : *factor;
        Expression term = to_text(size) == "1"          ? psi[i].form
                          : to_text(psi[i].form) == "1" ? size
                                                        : Expression::product({size, psi[i].form});
        terms.push_back(negative ? Expression::negation(std::move(term)) : std::move(term));
    }
    return "`" + to_text(Expression::sum(std::move(terms))) + "`";
}

void check_dependence(const Method& method, NumberVector v, std::vector<BasisFunction> psi) {
    ExactFunction sum;
    for (std::size_t i = 0; i < v.size(); ++i) {
        sum = sum + ExactFunction(v[i]) * psi[i].function;
    }
    if (!sum.terms().empty()) return;
    const auto first =
        std::find_if(v.begin(), v.end(), [](const Number& each) { return !each.is_zero(); });
    const auto factor = first->closed_form();
    if (factor && factor->kind == Expression::Kind::negation) {
        for (Number& each : v) { each = -each; }
    }
    // NOTE: the text begins with the last one.
    std::reverse(v.begin(), v.end());
    std::reverse(psi.begin(), psi.end());
    throw MathError("the functions are dependent: " + combination_text(v, psi) + " is 0",
                    whole(method.basis.source), "leave one of them out, and a node with it");
}

void check_constants(const Method& method, const std::vector<BasisFunction>& psi) {
    for (const BasisFunction& function : psi) {
        const auto constant = function.function.constant();
        if (constant && !constant->is_zero()) return;
    }
    // 1 is in the span when a combination of psi_1 .. psi_s, 1 vanishes that has 1 in it.
    const auto combination = left_null_vector(in_terms(psi, ExactFunction(Number(1))));
    if (combination && !combination->back().is_zero()) return;
    if (!has_independent_terms(psi) && !proved_independent_of_one(psi)) {
        throw MathError("cannot decide whether constants are in the span of the basis",
                        whole(method.basis.source), "write the basis with the function 1 in it");
    }
    throw MathError("constants are not in the span of the basis, so the method is not consistent",
                    whole(method.basis.source), "add the function 1");
}

void check_parameters(const Method& method, const std::vector<NumberMatrix>& matrices) {
    bool parameters = false;
    bool enclosed = false;
    for (const NumberMatrix& matrix : matrices) {
        for (const NumberVector& row : matrix) {
            for (const Number& number : row) {
                parameters = parameters || number.has_parameters();
                enclosed = enclosed || !is_exact(number);
            }
        }
    }
    if (parameters && enclosed) {
        throw InputError("a method with a free parameter and with numbers that have no closed form "
                         "is not built yet",
                         whole(method.basis.source), "give the parameter a value with --param");
    }
}

NumberVector integrals(const std::vector<BasisFunction>& functions, const Number& end,
                       const Ground& ground) {
    const Progress::Stage stage("integrating the basis");
    NumberVector result;
    for (const BasisFunction& function : functions) {
        const auto nowhere = [] { return std::string(); };
        result.push_back(of_function(function, nowhere,
                                     [&] { return function.function.integral(end, ground); }));
    }
    return result;
}

BasisIntegrals basis_integrals(const Ingredients& given) {
    const auto& [ground, psi, nodes] = given;
    BasisIntegrals result{integrals(psi, Number(1), ground), {}};
    for (const Number& node : nodes.c) {
        result.A_psi.push_back(node.is_one() ? result.B : integrals(psi, node, ground));
    }
    return result;
}

NumberMatrix values(const std::vector<BasisFunction>& functions, const NumberVector& nodes,
                    const Ground& ground) {
    const Progress::Stage stage("evaluating the basis at the nodes");
    NumberMatrix result;
    for (const BasisFunction& function : functions) {
        NumberVector row;
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            const auto where = [&] { return " at " + node_text(nodes, j); };
            row.push_back(of_function(function, where,
                                      [&] { return function.function.at(nodes[j], ground); }));
        }
        result.push_back(std::move(row));
    }
    return result;
}

}  // namespace hvi::gen
