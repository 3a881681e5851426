// The values of a graph's nodes in a field in which its inputs are free.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Functions of the inputs, in normal form. A function that the field does not contain, as log(q),
/// is a free symbol of its own, named by its text. A combination that vanishes then is proved to be
/// zero; one that does not may be zero all the same.
class NodeValues {
public:
    using Value = Number;

    [[nodiscard]] static Number integer(long value) { return value; }
    [[nodiscard]] static Number sum(const Number& a, const Number& b) { return a + b; }
    [[nodiscard]] static Number product(const Number& a, const Number& b) { return a * b; }
    [[nodiscard]] static bool is_zero(const Number& a) { return a.is_zero(); }
    /// Throws MathError where the matrix is singular.
    [[nodiscard]] static NumberMatrix inverse(const NumberMatrix& matrix);

    /// The graph may grow.
    NodeValues(const Graph& graph, Ground ground) : graph_(graph), ground_(std::move(ground)) {}

    /// Throws TooLarge.
    [[nodiscard]] Number operator()(const Scaled& a);

    /// Returns the expressions that are free symbols, by their names.
    [[nodiscard]] const std::map<std::string, Expression>& hidden() const { return hidden_; }

private:
    [[nodiscard]] Number at(Node node);
    [[nodiscard]] std::optional<Number> computed(const Computation& computation);
    [[nodiscard]] std::optional<Number> root(Node argument);
    [[nodiscard]] Number hide(Node node);
    [[nodiscard]] Number symbol(const std::string& name) const;

    const Graph& graph_;
    Ground ground_;
    std::map<Node, Number> known_;
    std::map<Node, std::optional<Number>> roots_;  ///< by their arguments
    std::map<std::string, Expression> hidden_;
};

}  // namespace hvi::gen
