// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/node_values.hpp"

#include <utility>
#include <vector>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/numbers/budget.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/graph/written.hpp"

namespace hvi::gen {

namespace {

Number number(const SmallFraction& fraction) {
    return Number(fraction.above) / Number(fraction.below);
}

/// Evaluates an expression in exact arithmetic; returns nothing where it has no value there.
std::optional<Number> evaluated(const Expression& expression, const Ground& ground) {
    try {
        const Number result = evaluate_number(expression, nullptr, ground);
        return is_exact(result) ? std::optional(result) : std::nullopt;
    } catch (const TooLarge&) { throw; } catch (const MathError&) {
        return std::nullopt;
    } catch (const InputError&) { return std::nullopt; }
}

/// Applies the operation to these values of its arguments.
std::optional<Number> applied(const Computation& computation, const NumberVector& values,
                              const Ground& ground) {
    Ground local = ground;
    std::vector<Expression> symbols;
    for (const Number& value : values) {
        const std::string name = "argument " + std::to_string(symbols.size());
        local.set_parameter(name, value);
        symbols.push_back(Expression::symbol(name));
    }
    return evaluated(of_operation(computation, std::move(symbols)), local);
}

}  // namespace

NumberMatrix NodeValues::inverse(const NumberMatrix& matrix) {
    const auto found = gen::inverse(matrix);
    if (!found) { throw MathError("d2H/dp2 is singular"); }
    return found->adjugate * (Number(1) / found->determinant);
}

Number NodeValues::operator()(const Scaled& a) { return number(a.factor) * at(a.node); }

Number NodeValues::at(Node node) {
    const auto known = known_.find(node);
    if (known != known_.end()) { return known->second; }
    // NOTE: a copy, since a graph that grows moves its nodes.
    const auto value = computed(Computation(graph_.at(node)));
    return known_.emplace(node, value ? *value : hide(node)).first->second;
}

std::optional<Number> NodeValues::computed(const Computation& computation) {
    if (computation.operation == Operation::constant) {
        return evaluated(computation.constant, ground_);
    }
    if (computation.operation == Operation::input) { return symbol(computation.name); }
    if (computation.operation == Operation::sum) {
        Number sum;
        for (const Scaled& term : computation.terms) { sum = sum + (*this)(term); }
        return sum;
    }
    const Node first = computation.arguments.front();
    if (computation.operation == Operation::square_root) { return root(first); }
    if (computation.operation == Operation::inverse_square_root) {
        const auto below = root(first);
        return below ? std::optional(Number(1) / *below) : std::nullopt;
    }
    NumberVector values;
    for (const Node argument : computation.arguments) { values.push_back(at(argument)); }
    if (computation.operation == Operation::product) { return values[0] * values[1]; }
    return applied(computation, values, ground_);
}

/// Returns a root, and remembers it. NOTE: after sqrt(u) the field has the root of u, but not its
/// sign; so 1/sqrt(u) needs the remembered root.
std::optional<Number> NodeValues::root(Node argument) {
    const auto [entry, is_new] = roots_.try_emplace(argument);
    if (is_new) {
        const Number square = at(argument);
        entry->second = square.has_parameters() ? ground_.new_root(square)
                                                : std::optional(ground_.sqrt(square));
        if (entry->second && !is_exact(*entry->second)) { entry->second.reset(); }
    }
    return entry->second;
}

Number NodeValues::hide(Node node) {
    const auto expression = written(graph_, {{1, 1}, node});
    if (!expression) { throw TooLarge(); }
    const std::string name = to_text(*expression);
    hidden_.emplace(name, *expression);
    return symbol(name);
}

Number NodeValues::symbol(const std::string& name) const {
    try {
        return ground_.parameter(name);
    } catch (const InputError&) { throw TooLarge(); }  // more symbols than the field has place for
}

}  // namespace hvi::gen
