// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/node_balls.hpp"

#include <string>
#include <utility>
#include <vector>

#include "generator/graph/written.hpp"

namespace hvi::gen {

namespace {

constexpr Precision bits = 256;

}  // namespace

Ball NodeBalls::integer(long value) {
    Ball result;
    arb_set_si(result.get(), value);
    return result;
}

Ball NodeBalls::sum(const Ball& a, const Ball& b) {
    Ball result;
    arb_add(result.get(), a.get(), b.get(), bits);
    return result;
}

Ball NodeBalls::product(const Ball& a, const Ball& b) {
    Ball result;
    arb_mul(result.get(), a.get(), b.get(), bits);
    return result;
}

bool NodeBalls::is_zero(const Ball& a) { return arb_is_zero(a.get()) != 0; }

Ball NodeBalls::operator()(const Scaled& a) {
    Ball result = product(integer(a.factor.above), at(a.node));
    arb_div_si(result.get(), result.get(), a.factor.below, bits);
    return result;
}

const Ball& NodeBalls::at(Node node) {
    const auto known = known_.find(node);
    if (known != known_.end()) { return known->second; }
    // NOTE: a copy, since a graph that grows moves its nodes.
    Ball value = computed(Computation(graph_.at(node)));
    return known_.emplace(node, std::move(value)).first->second;
}

Ball NodeBalls::computed(const Computation& computation) {
    if (computation.operation == Operation::constant) {
        return value_at(computation.constant, {}, nullptr);
    }
    if (computation.operation == Operation::input) { return inputs_.at(computation.name); }
    if (computation.operation == Operation::sum) {
        Ball result = integer(0);
        for (const Scaled& term : computation.terms) { result = sum(result, (*this)(term)); }
        return result;
    }
    SymbolValues values;
    std::vector<Expression> symbols;
    for (const Node argument : computation.arguments) {
        const std::string name = std::to_string(symbols.size());
        values.emplace(name, at(argument));
        symbols.push_back(Expression::symbol(name));
    }
    return value_at(of_operation(computation, std::move(symbols)), values, nullptr);
}

}  // namespace hvi::gen
