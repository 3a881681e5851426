// The value of a node, one by one as it is written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

using Real = long double;
using Values = std::map<std::string, Real>;

/// Evaluates an expression by itself, for comparison with the graph.
inline Real value(const Expression& expression, const Values& inputs) {
    using Kind = Expression::Kind;
    const auto argument = [&](std::size_t k) { return value(expression.arguments.at(k), inputs); };
    switch (expression.kind) {
    case Kind::number: return std::stold(expression.numerator) / std::stold(expression.denominator);
    case Kind::symbol:
        if (expression.name == "pi") { return std::numbers::pi_v<Real>; }
        if (expression.name == "e") { return std::numbers::e_v<Real>; }
        return inputs.at(expression.name);
    case Kind::negation: return -argument(0);
    case Kind::reciprocal: return 1 / argument(0);
    case Kind::power: return std::pow(argument(0), argument(1));
    case Kind::sum: {
        Real sum = 0;
        for (std::size_t k = 0; k < expression.arguments.size(); ++k) { sum += argument(k); }
        return sum;
    }
    case Kind::product: {
        Real product = 1;
        for (std::size_t k = 0; k < expression.arguments.size(); ++k) { product *= argument(k); }
        return product;
    }
    case Kind::call: break;
    case Kind::element:
    case Kind::sum_over: throw std::logic_error("indices are unrolled");
    }
    if (expression.name == "if<") { return argument(0) < argument(1) ? argument(2) : argument(3); }
    if (expression.name == "if<=") {
        return argument(0) <= argument(1) ? argument(2) : argument(3);
    }
    if (expression.name == "min") { return std::min(argument(0), argument(1)); }
    if (expression.name == "max") { return std::max(argument(0), argument(1)); }
    if (expression.name == "atan2") { return std::atan2(argument(0), argument(1)); }
    static const std::map<std::string, Real (*)(Real, Real)> own{
        {"W", [](Real a, Real b) { return std::sin(a) * std::exp(2 * b); }},
        {"W_1", [](Real a, Real b) { return std::cos(a) * std::exp(2 * b); }},
        {"W_2", [](Real a, Real b) { return 2 * std::sin(a) * std::exp(2 * b); }},
        {"W_11", [](Real a, Real b) { return -std::sin(a) * std::exp(2 * b); }},
        {"W_12", [](Real a, Real b) { return 2 * std::cos(a) * std::exp(2 * b); }},
        {"W_22", [](Real a, Real b) { return 4 * std::sin(a) * std::exp(2 * b); }}};
    const auto found = own.find(expression.name);
    if (found != own.end()) { return found->second(argument(0), argument(1)); }
    static const std::map<std::string, Real (*)(Real)> functions{
        {"sqrt", std::sqrt},
        {"exp", std::exp},
        {"log", std::log},
        {"sin", std::sin},
        {"cos", std::cos},
        {"tan", std::tan},
        {"asin", std::asin},
        {"acos", std::acos},
        {"atan", std::atan},
        {"sinh", std::sinh},
        {"cosh", std::cosh},
        {"tanh", std::tanh},
        {"log10", std::log10},
        {"cbrt", std::cbrt},
        {"asinh", std::asinh},
        {"acosh", std::acosh},
        {"atanh", std::atanh},
        {"erf", std::erf},
        {"erfc", std::erfc},
        {"abs", std::abs},
        {"sign", [](Real x) { return x < 0   ? Real(-1)
                                     : x > 0 ? Real(1)
                                             : Real(0); }}};
    return functions.at(expression.name)(argument(0));
}

inline Real value(const Graph& graph, Node node, const Values& inputs) {
    const Computation& computation = graph.at(node);
    const auto argument = [&](std::size_t k) {
        return value(graph, computation.arguments.at(k), inputs);
    };
    switch (computation.operation) {
    case Operation::constant: return value(computation.constant, {});
    case Operation::input: return inputs.at(computation.name);
    case Operation::sum: {
        Real sum = 0;
        for (const Scaled& term : computation.terms) {
            sum += value(graph, term.node, inputs) * static_cast<Real>(term.factor.above) /
                   static_cast<Real>(term.factor.below);
        }
        return sum;
    }
    case Operation::product: return argument(0) * argument(1);
    case Operation::inverse: return 1 / argument(0);
    case Operation::square_root: return std::sqrt(argument(0));
    case Operation::inverse_square_root: return 1 / std::sqrt(argument(0));
    case Operation::power: return std::pow(argument(0), argument(1));
    case Operation::call: break;
    }
    Values arguments;
    std::vector<Expression> symbols;
    for (std::size_t k = 0; k < computation.arguments.size(); ++k) {
        symbols.push_back(Expression::symbol("x" + std::to_string(k)));
        arguments[symbols.back().name] = argument(k);
    }
    return value(Expression::call(computation.name, symbols), arguments);
}

inline Real value(const Graph& graph, const Scaled& a, const Values& inputs) {
    return value(graph, a.node, inputs) * static_cast<Real>(a.factor.above) /
           static_cast<Real>(a.factor.below);
}

}  // namespace hvi::gen
