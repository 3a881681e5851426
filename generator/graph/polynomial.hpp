// Values of a graph as polynomials in its nodes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// A product of powers of nodes that vary, ascending by node: twice the exponent of each, never 0.
/// A root of a node and its inverse are powers of it.
using PowerProduct = std::vector<std::pair<Node, long>>;

/// A sum of monomials, with coefficients that do not vary and are not 0.
using NodePolynomial = std::map<PowerProduct, Scaled>;

/// Multiplies values out. Numbers are folded with parameters, and like monomials come together.
class Expansion {
public:
    /// `is_whole`: whether a node is left as it is, and is one variable of polynomials.
    Expansion(Graph& graph, std::function<bool(Node)> is_whole)
        : graph_(graph), is_whole_(std::move(is_whole)) {}

    /// Returns the value as a polynomial. NOTE: a sum of inputs alone is a variable too, unless it
    /// is the value itself: x - y is the distance of two bodies, and c x - c y would lose its
    /// digits. So is what has many monomials, or a high degree.
    [[nodiscard]] NodePolynomial operator()(const Scaled& value);

private:
    [[nodiscard]] const NodePolynomial& at(Node node);
    /// Returns a sum or a product, multiplied out; any other node as a power.
    [[nodiscard]] NodePolynomial opened(Node node);
    [[nodiscard]] NodePolynomial sum(const std::vector<Scaled>& terms);
    [[nodiscard]] NodePolynomial product(const NodePolynomial& a, const NodePolynomial& b);
    /// Returns 1/node: of a product of powers the product of the inverse powers.
    [[nodiscard]] NodePolynomial inverse(Node node);
    [[nodiscard]] bool stays_whole(Node node) const;
    void add(NodePolynomial& polynomial, const PowerProduct& monomial, const Scaled& coefficient);

    Graph& graph_;
    std::function<bool(Node)> is_whole_;
    std::map<Node, NodePolynomial> known_;
};

/// A polynomial as a product: the sum or difference of two variables, and what it leaves.
struct LinearFactor {
    Scaled factor;
    NodePolynomial quotient;
};

/// Returns the sums and differences of two variables that divide a short polynomial without a
/// remainder, as r - s divides r + a r^2 - s - a s^2. Empty where that has few variables or many.
[[nodiscard]] std::vector<LinearFactor> linear_factors(Graph& graph,
                                                       const NodePolynomial& polynomial);

}  // namespace hvi::gen
