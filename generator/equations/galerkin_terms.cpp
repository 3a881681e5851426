// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/galerkin_terms.hpp"

#include <utility>

namespace hvi::gen {

namespace {

/// Returns the name of a coordinate's unknowns without an index.
std::string rate_of(const std::string& coordinate) { return "v_" + coordinate; }

StageTerms terms_at_nodes(const std::vector<std::string>& coordinates,
                          std::vector<std::string> varying, std::set<std::string> taken,
                          std::size_t nodes) {
    taken.insert(varying.begin(), varying.end());
    for (const std::string& coordinate : coordinates) varying.push_back(rate_of(coordinate));
    return StageTerms(stage_names(varying, taken, nodes));
}

/// Multiplies values at the nodes by the weights of the rule.
NumberVector weighted(const NumberVector& b, NumberVector numbers) {
    for (std::size_t i = 0; i < b.size(); ++i) numbers[i] = b[i] * numbers[i];
    return numbers;
}

NumberVector column(const NumberMatrix& matrix, std::size_t j) {
    NumberVector result;
    for (const NumberVector& row : matrix) result.push_back(row[j]);
    return result;
}

}  // namespace

GalerkinTerms::GalerkinTerms(const GalerkinRule& rule, const std::vector<std::string>& coordinates,
                             std::vector<std::string> varying, std::set<std::string> taken)
    : rule_(rule),
      terms_(terms_at_nodes(coordinates, std::move(varying), std::move(taken), rule.nodes())) {}

std::vector<Equation> GalerkinTerms::times() {
    std::vector<Equation> result;
    for (std::size_t i = 0; i < rule_.nodes(); ++i) result.push_back(terms_.time(i, rule_.c[i]));
    return result;
}

Expression GalerkinTerms::position(const std::string& x, std::size_t node) {
    return terms_.moved(Expression::symbol(x), Expression::symbol(rate_of(x)),
                        terms_.written(rule_.A_psi[node]), false);
}

Expression GalerkinTerms::position_at_end(const std::string& x) {
    return terms_.moved(Expression::symbol(x), Expression::symbol(rate_of(x)),
                        terms_.written(rule_.B), false);
}

Expression GalerkinTerms::velocity(const std::string& x, std::size_t node) {
    return terms_.sum(Expression::symbol(rate_of(x)), terms_.written(column(rule_.Psi, node)));
}

ImplicitEquation GalerkinTerms::condition(const Expression& momentum, const std::string& p,
                                          const Expression& slope, bool falls,
                                          std::size_t function) {
    const Number& B = rule_.B[function];
    NumberVector rest;
    for (const Number& A : column(rule_.A_psi, function)) rest.push_back(B - A);
    return {terms_.sum(momentum, terms_.written(weighted(rule_.b, rule_.Psi[function]))),
            terms_.moved(terms_.multiple(B, Expression::symbol(p)), slope,
                         terms_.written(weighted(rule_.b, std::move(rest))), falls)};
}

Expression GalerkinTerms::momentum_at_end(const std::string& p, const Expression& slope,
                                          bool falls) {
    return terms_.moved(Expression::symbol(p), slope, terms_.written(rule_.b), falls);
}

}  // namespace hvi::gen
