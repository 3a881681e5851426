// The equations of a step for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <map>

#include "generator/render/equations.hpp"
#include "generator/render/equations_page.hpp"
#include "generator/render/layout.hpp"

namespace hvi::gen {

namespace {

/// Returns the new value of a variable: a row of the map, without zeros.
Expression new_value(const MapEquations& map, std::size_t row,
                     const std::vector<std::string>& names) {
    const Expression zero = Expression::integer(0), one = Expression::integer(1);
    std::vector<Expression> terms;
    for (std::size_t j = 0; j < names.size(); ++j) {
        const Expression& entry = map.matrix[row][j];
        const Expression variable = Expression::symbol(names[j]);
        if (entry == zero) continue;
        terms.push_back(entry == one ? variable : Expression::product({entry, variable}));
    }
    if (!(map.offset[row] == zero)) terms.push_back(map.offset[row]);
    return Expression::sum(std::move(terms));
}

/// Returns the momenta with a prime.
std::map<std::string, std::string> names_at_the_end(const StepEquations& step) {
    std::map<std::string, std::string> names;
    for (const std::string& name : step.momenta) names[name] = name + "'";
    return names;
}

/// Returns q*p', or its sum over all degrees of freedom.
std::string identity(const StepEquations& step) {
    std::vector<std::string> products;
    for (std::size_t i = 0; i < step.momenta.size(); ++i)
        products.push_back(step.coordinates[i] + "*" + step.momenta[i] + "'");
    return fmt::format("{}", fmt::join(products, "+"));
}

void write_head(EquationsPage& page, const StepEquations& step) {
    page.title(step);
    page.remark("\n");
    page.fact("hamiltonian", to_text(step.hamiltonian));
    page.names("coordinates", step.coordinates);
    page.names("momenta", step.momenta);
    page.parameters(step);
}

void write_map(EquationsPage& page, const StepEquations& step) {
    const std::vector<std::string> names = variables(step);
    for (std::size_t i = 0; i < names.size(); ++i)
        page.equation(names[i] + "'", new_value(*step.map, i, names));
}

/// Writes an equation; one that does not fit into a line is broken at the equals sign.
void write_implicit(EquationsPage& page, const ImplicitEquation& equation) {
    const std::string left = to_text(equation.left);
    const std::size_t length = left.size() + to_text(equation.right).size();
    if (length + std::string_view("  = ").size() <= terminal_columns) {
        page.equation(left, equation.right);
        return;
    }
    page.line(" ", left);
    page.equation("  ", equation.right);
}

void write_galerkin(EquationsPage& page, const GalerkinEquations& equations) {
    for (const Equation& position : equations.positions)
        page.equation(position.left, position.right);
    for (const ImplicitEquation& condition : equations.conditions) write_implicit(page, condition);
    page.remark("\nand with them:\n\n");
    for (const Equation& update : equations.update) page.equation(update.left + "'", update.right);
    if (!equations.is_exact) page.remark(EquationsPage::inexact);
}

void write_obstacle(EquationsPage& page, const StepEquations& step) {
    if (step.obstacle.empty()) return;
    page.line("", "H is quadratic, but the map has no formula here: " + step.obstacle);
    page.remark("\n");
}

void write_at_nodes(EquationsPage& page, const StepEquations& step) {
    write_obstacle(page, step);
    page.remark("stages by (4.6), to be solved together for the values of p at the nodes,\n"
                "and for the V, coefficients of dq/dt in the basis:\n\n");
    write_galerkin(page, *step.at_nodes);
}

void write_stages(EquationsPage& page, const StepEquations& step) {
    const StageEquations& equations = *step.stages;
    write_obstacle(page, step);
    if (!equations.is_explicit) page.remark("stages, to be solved together:\n\n");
    for (const Equation& stage : equations.stages) page.equation(stage.left, stage.right);
    if (!equations.is_explicit) page.remark("\nand with them:\n\n");
    for (const Equation& update : equations.update) page.equation(update.left + "'", update.right);
    if (equations.is_explicit) page.remark("\nEach line needs those above it only.\n");
    if (!equations.is_exact) page.remark(EquationsPage::inexact);
}

void write_generating(EquationsPage& page, const StepEquations& step) {
    const GeneratingEquations& found = *step.generating;
    const auto at_the_end = names_at_the_end(step);
    page.remark(fmt::format("\ngenerating function of type II, by {}:\n\n",
                            step.basis.empty() ? "(4.19)" : "(4.2)"));
    page.equation("H_d^+", renamed(found.discrete, at_the_end));
    if (found.exact) {
        page.remark("\nexact discrete Hamiltonian, (4.1):\n\n");
        page.equation("H_d,exact^+", renamed(*found.exact, at_the_end));
    }
    page.remark("\n");
    page.fact("gives map", fmt::format("{}, by p = D_1 H_d^+ and q' = D_2 H_d^+ (3.10)",
                                       found.gives_map ? "yes" : "no"));
    page.fact("symmetric", found.is_symmetric ? "yes, the mixed second derivatives agree"
                                              : "no, the mixed second derivatives differ");
    page.fact("type I", found.has_type_one
                            ? "yes, dq'/dp is regular but for single h"
                            : "no, dq'/dp is singular for every h: (q, q') are not independent");
    page.fact("difference",
              fmt::format("H_d^+ - H_d,exact^+ = O(h^{}){}", found.order_of_difference,
                          found.is_at_least ? " at least" : ""));
}

/// Writes a term; [h^k] is the coefficient of h^k.
void write_term(EquationsPage& page, const StepEquations& step, std::size_t k,
                const DiscreteSeries::Coefficient& coefficient) {
    const std::string power = k == 1 ? "h" : fmt::format("h^{}", k);
    page.line(fmt::format(" [{}] = ", power),
              coefficient ? to_text(renamed(*coefficient, names_at_the_end(step)))
                          : "... (too long to be computed)");
}

void write_terms(EquationsPage& page, const StepEquations& step,
                 const std::vector<DiscreteSeries::Coefficient>& coefficients) {
    page.line(" [1] = ", identity(step));
    for (std::size_t k = 1; k <= coefficients.size(); ++k)
        write_term(page, step, k, coefficients[k - 1]);
}

void write_series(EquationsPage& page, const StepEquations& step) {
    const DiscreteSeries& found = *step.series;
    if (step.map || step.stages) page.remark("\n");
    page.remark("coefficients of powers of h in the exact discrete Hamiltonian, (4.1):\n\n");
    write_terms(page, step, found.exact);
    page.remark("\nand in the H_d^+ of the method, (4.19):\n\n");
    write_terms(page, step, found.method);
    page.remark("\n");
    if (found.first_difference) {
        const auto power = static_cast<std::size_t>(*found.first_difference);
        page.fact("difference",
                  fmt::format("H_d^+ - H_d,exact^+ = O(h^{}), and {}", power,
                              found.difference ? "its first coefficient is" : "that is not 0"));
        if (!found.difference) return;
        page.remark("\n");
        write_term(page, step, power, found.difference);
    } else if (found.undecided) {
        page.fact("difference",
                  fmt::format("none before h^{}, and there it is not decided", *found.undecided));
    } else {
        page.fact("difference", fmt::format("none up to h^{}", found.exact.size()));
    }
}

void write_lagrangian_head(EquationsPage& page, const LagrangianEquations& step) {
    page.title(step);
    page.remark("\n");
    page.fact("lagrangian", to_text(step.lagrangian));
    page.names("coordinates", step.coordinates);
    page.names("velocities", step.velocities);
    page.names("momenta", step.momenta);
    page.parameters(step);
}

}  // namespace

std::string render_text(const StepEquations& step) {
    EquationsPage page;
    write_head(page, step);
    if (step.map) write_map(page, step);
    if (step.stages) write_stages(page, step);
    if (step.at_nodes) write_at_nodes(page, step);
    if (step.generating) write_generating(page, step);
    if (step.series) write_series(page, step);
    return page.text();
}

std::string render_text(const LagrangianEquations& step) {
    EquationsPage page;
    write_lagrangian_head(page, step);
    page.remark("momenta, by p = dL/dv:\n\n");
    for (const Equation& momentum : step.legendre) page.equation(momentum.left, momentum.right);
    page.remark(step.basis.empty()
                    ? "\nstages by (4.14), to be solved together for the velocities in them:\n\n"
                    : "\nstages by (4.14), to be solved together for the V, coefficients of\n"
                      "dq/dt in the basis:\n\n");
    write_galerkin(page, step);
    return page.text();
}

}  // namespace hvi::gen
