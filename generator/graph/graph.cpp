// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/graph/graph.hpp"

#include <algorithm>
#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/expr/own_functions.hpp"
#include "generator/graph/pythagoras.hpp"
#include "generator/graph/written.hpp"

namespace hvi::gen {

namespace {

Expression multiple(const SmallFraction& factor, const Expression& constant) {
    return factor.is_one() ? constant : Expression::product({as_expression(factor), constant});
}

/// Returns the common factor of a sum: that of its first term if all are equal in size, else 1;
/// with the sign of the first.
SmallFraction common_factor(const std::vector<Scaled>& terms) {
    const SmallFraction first = terms.front().factor;
    const bool all_equal = std::all_of(terms.begin(), terms.end(), [&](const Scaled& term) {
        return term.factor.size() == first.size();
    });
    if (all_equal) { return first; }
    return {first.above < 0 ? -1 : 1, 1};
}

/// Returns the terms in ascending order of their nodes, with like terms added up and without zeros.
std::vector<Scaled> merged(std::vector<Scaled> terms) {
    std::stable_sort(terms.begin(), terms.end(),
                     [](const Scaled& a, const Scaled& b) { return a.node < b.node; });
    std::vector<Scaled> result;
    for (const Scaled& term : terms) {
        if (term.is_zero()) { continue; }
        const bool is_like = !result.empty() && result.back().node == term.node;
        const auto folded =
            is_like ? result.back().factor + term.factor : std::optional<SmallFraction>();
        if (!folded) {
            result.push_back(term);
        } else if (folded->is_zero()) {
            result.pop_back();
        } else {
            result.back().factor = *folded;
        }
    }
    return result;
}

}  // namespace

Graph::Graph() {
    const Scaled first = constant(Expression::integer(1));
    HVI_CHECK(first.node == one);
}

Node Graph::insert(Computation computation) {
    for (const Scaled& term : computation.terms) { computation.roles |= at(term.node).roles; }
    for (const Node argument : computation.arguments) { computation.roles |= at(argument).roles; }
    if (const auto value = folded(computation)) { return constant(*value).node; }
    Key key{computation.operation, computation.terms, computation.arguments, computation.name};
    const auto [found, is_new] = numbers_.emplace(std::move(key), static_cast<Node>(size()));
    if (is_new) { computations_.push_back(std::move(computation)); }
    return found->second;
}

std::optional<Expression> Graph::folded(const Computation& computation) const {
    const bool is_call = computation.operation == Operation::call;
    if (is_call && is_own_function(computation.name)) { return {}; }
    std::vector<Expression> values;
    const auto add = [&](const SmallFraction& factor, Node node) {
        if (at(node).operation == Operation::constant) {
            values.push_back(multiple(factor, at(node).constant));
        }
    };
    for (const Scaled& term : computation.terms) { add(term.factor, term.node); }
    for (const Node argument : computation.arguments) { add({1, 1}, argument); }
    const std::size_t operands = computation.terms.size() + computation.arguments.size();
    if (operands == 0 || values.size() < operands) { return {}; }
    Expression value = of_operation(computation, std::move(values));
    // NOTE: a text repeats what a graph shares, so that powers of constants could grow without end.
    constexpr std::size_t longest = 1000;
    return to_text(value).size() <= longest ? std::optional(std::move(value)) : std::nullopt;
}

Scaled Graph::constant(const Expression& expression) {
    Computation computation;
    computation.name = to_text(expression);
    computation.constant = expression;
    return {{1, 1}, insert(std::move(computation))};
}

Scaled Graph::input(const std::string& name, Role role) {
    return input(name, static_cast<Roles>(role));
}

Scaled Graph::input(const std::string& name, Roles roles) {
    Computation computation;
    computation.operation = Operation::input;
    computation.name = name;
    computation.roles = roles;
    return {{1, 1}, insert(std::move(computation))};
}

Scaled Graph::times(const SmallFraction& factor, const Scaled& a) {
    if (factor.is_zero() || a.is_zero()) { return number(0); }
    if (const auto folded = factor * a.factor) { return {*folded, a.node}; }
    return product({factor, whole(constant(as_expression(a.factor)))}, {{1, 1}, a.node});
}

Scaled Graph::sum(std::vector<Scaled> terms) {
    terms = merged(std::move(terms));
    while (apply_pythagoras(*this, terms)) { terms = merged(std::move(terms)); }
    if (terms.empty()) { return number(0); }
    if (terms.size() == 1) { return terms.front(); }
    const SmallFraction common = common_factor(terms);
    const SmallFraction inverse = SmallFraction::of(common.below, common.above).value();
    for (Scaled& term : terms) { term.factor = (term.factor * inverse).value(); }
    Computation computation;
    computation.operation = Operation::sum;
    computation.terms = std::move(terms);
    return {common, insert(std::move(computation))};
}

Scaled Graph::product(const Scaled& a, const Scaled& b) {
    if (is_number(a)) { return times(a.factor, b); }
    if (is_number(b)) { return times(b.factor, a); }
    const auto is_inverse_of = [&](Node x, Node y) {
        return at(x).operation == Operation::inverse && at(x).arguments.front() == y;
    };
    const Node first = std::min(a.node, b.node);
    const Node second = std::max(a.node, b.node);
    if (is_inverse_of(second, first)) { return product(number(a.factor), number(b.factor)); }
    if (first == second && at(first).operation == Operation::square_root) {
        const Scaled square{{1, 1}, at(first).arguments.front()};
        return times(a.factor, times(b.factor, square));
    }
    Computation computation;
    computation.operation = Operation::product;
    computation.arguments = {first, second};
    const Node node = insert(std::move(computation));
    return times(a.factor, {b.factor, node});
}

Scaled Graph::inverse(const Scaled& a) {
    HVI_CHECK(!a.is_zero());
    const SmallFraction factor = SmallFraction::of(a.factor.below, a.factor.above).value();
    if (is_number(a)) { return number(factor); }
    const Computation& computation = at(a.node);
    if (computation.operation == Operation::inverse) {
        return {factor, computation.arguments.front()};
    }
    Computation result;
    result.operation = Operation::inverse;
    result.arguments = {a.node};
    if (computation.operation == Operation::square_root) {
        result.operation = Operation::inverse_square_root;
        result.arguments = computation.arguments;
    }
    return {factor, insert(std::move(result))};
}

Node Graph::whole(const Scaled& a) {
    if (a.factor.is_one()) { return a.node; }
    if (is_number(a)) { return constant(as_expression(a.factor)).node; }
    Computation computation;
    computation.operation = Operation::sum;
    computation.terms = {a};
    return insert(std::move(computation));
}

Scaled Graph::settled(const Scaled& a) {
    if (is_number(a)) { return a; }
    return {{a.factor.above < 0 ? -1 : 1, 1}, whole({a.factor.size(), a.node})};
}

Scaled Graph::root(const Scaled& a, Operation operation) {
    Computation computation;
    computation.operation = operation;
    computation.arguments = {whole(a)};
    return {{1, 1}, insert(std::move(computation))};
}

Scaled Graph::half_power(const Scaled& a, long twice_exponent) {
    if (twice_exponent == 0 || a == number(1)) { return number(1); }
    if (a.is_zero() && twice_exponent > 0) { return number(0); }
    const bool is_whole = twice_exponent % 2 == 0;
    if (twice_exponent < 0) {
        if (is_whole) { return whole_power(inverse(a), -twice_exponent / 2); }
        if (twice_exponent == -1) { return root(a, Operation::inverse_square_root); }
        return remember_half_power(negative_half_power(a, twice_exponent), a, twice_exponent);
    }
    const Scaled power = whole_power(a, twice_exponent / 2);
    if (is_whole) { return power; }
    return remember_half_power(product(power, root(a, Operation::square_root)), a, twice_exponent);
}

Scaled Graph::negative_half_power(const Scaled& a, long twice_exponent) {
    if (twice_exponent == -5) {
        // Derivatives of a^(-3/2) have a^(-5/2). a^(-3/2) is known then: no further division.
        const Scaled cube = half_power(a, -3);
        return product(product(cube, cube), half_power(a, 1));
    }
    // NOTE: not a power of 1/sqrt(a), which takes one product more, and waits for the division.
    return inverse(half_power(a, -twice_exponent));
}

Scaled Graph::remember_half_power(const Scaled& power, const Scaled& a, long twice_exponent) {
    if (power.factor == SmallFraction{1, 1}) {
        half_powers_.emplace(power.node, HalfPower{a, twice_exponent});
    }
    return power;
}

std::optional<HalfPower> Graph::half_power_at(Node node) const {
    const auto found = half_powers_.find(node);
    return found == half_powers_.end() ? std::nullopt : std::optional(found->second);
}

Scaled Graph::whole_power(const Scaled& base, long exponent) {
    Scaled result = number(1);
    Scaled square = base;
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 != 0) { result = product(result, square); }
        if (exponent > 1) { square = product(square, square); }
    }
    return result;
}

Scaled Graph::power(const Scaled& base, const Scaled& exponent) {
    if (base == number(1)) { return base; }
    Computation computation;
    computation.operation = Operation::power;
    computation.arguments = {whole(base), whole(exponent)};
    return {{1, 1}, insert(std::move(computation))};
}

Scaled Graph::call(const std::string& function, const std::vector<Scaled>& arguments) {
    if (function == "sqrt") { return half_power(arguments.front(), 1); }
    // NOTE: a choice is between its last two arguments.
    if (is_choice(function) && arguments.back() == *(arguments.end() - 2)) {
        return arguments.back();
    }
    Computation computation;
    computation.operation = Operation::call;
    computation.name = function;
    for (const Scaled& argument : arguments) { computation.arguments.push_back(whole(argument)); }
    return {{1, 1}, insert(std::move(computation))};
}

bool has_kinks(const Graph& graph, const std::vector<Scaled>& values) {
    std::vector<bool> is_needed(graph.size());
    for (const Scaled& value : values) { is_needed[value.node] = true; }
    for (auto node = static_cast<Node>(graph.size()); node-- > 0;) {
        const Computation& computation = graph.at(node);
        if (!is_needed[node] || (computation.roles & of_motion) == 0) { continue; }
        const bool is_call = computation.operation == Operation::call;
        if (is_call && !is_smooth(computation.name)) { return true; }
        for (const Scaled& term : computation.terms) { is_needed[term.node] = true; }
        for (const Node argument : computation.arguments) { is_needed[argument] = true; }
    }
    return false;
}

}  // namespace hvi::gen
