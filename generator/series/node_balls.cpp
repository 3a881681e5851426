// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/node_balls.hpp"

#include <arb_mat.h>

#include <string>
#include <utility>

#include "generator/graph/written.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr Precision bits = 256;

/// A square matrix, freed by its destructor.
struct MatrixOfBalls {
    explicit MatrixOfBalls(std::size_t size) { arb_mat_init(entries, slong(size), slong(size)); }
    MatrixOfBalls(const MatrixOfBalls&) = delete;
    MatrixOfBalls& operator=(const MatrixOfBalls&) = delete;
    ~MatrixOfBalls() { arb_mat_clear(entries); }

    [[nodiscard]] arb_ptr at(std::size_t i, std::size_t j) {
        return arb_mat_entry(entries, slong(i), slong(j));
    }

    arb_mat_t entries;
};

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

std::vector<std::vector<Ball>> NodeBalls::inverse(const std::vector<std::vector<Ball>>& matrix) {
    const std::size_t size = matrix.size();
    MatrixOfBalls a(size), b(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) { arb_set(a.at(i, j), matrix[i][j].get()); }
    }
    if (arb_mat_inv(b.entries, a.entries, bits) == 0) {
        throw MathError("d2H/dp2 is not proved to be regular");
    }
    std::vector<std::vector<Ball>> result(size, std::vector<Ball>(size));
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) { arb_set(result[i][j].get(), b.at(i, j)); }
    }
    return result;
}

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
