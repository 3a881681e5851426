// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/derivative.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "generator/expr/functions.hpp"
#include "generator/expr/own_functions.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

namespace {

/// Returns the expressions of functions.def, by their texts.
std::map<std::string_view, Expression> expressions_of_functions() {
    std::map<std::string_view, Expression> expressions;
    for (const Function& function : functions()) {
        for (const std::string_view text : {function.derivative, function.by_second}) {
            if (text.empty()) { continue; }
            expressions.emplace(text, parse_expression(given("functions.def", std::string(text))));
        }
    }
    return expressions;
}

/// Lowers a text of functions.def, with the function's arguments and its value for names.
Scaled lowered(Graph& graph, std::string_view text, const std::vector<Scaled>& arguments,
               const Scaled& value) {
    static const auto expressions = expressions_of_functions();
    const Symbols symbols = arguments.size() == 1
                                ? Symbols{{"x", arguments[0]}, {"y", value}}
                                : Symbols{{"a", arguments[0]}, {"b", arguments[1]}};
    return lower(graph, expressions.at(text), symbols, nullptr);
}

/// Returns the derivative of a function by its argument number k; `value` is the value of the
/// function.
Scaled derivative(Graph& graph, const std::string& name, const std::vector<Scaled>& arguments,
                  const Scaled& value, std::size_t k) {
    if (is_own_function(name)) { return graph.call(own_derivative(name, k), arguments); }
    const Function& function = *find_function(name);
    return lowered(graph, k == 0 ? function.derivative : function.by_second, arguments, value);
}

/// Gradients of the alternatives that functions choose from, each once.
using Gradients = std::map<Node, std::vector<Scaled>>;

/// Reverse sweep: goes down from f, and adds each node's share to its arguments.
class Reverse {
public:
    Reverse(Graph& graph, const Scaled& f, const std::vector<Node>& inputs, Shares handed,
            Gradients& known)
        : graph_(graph),
          inputs_(inputs),
          handed_(handed),
          known_(known),
          shares_(f.node + 1),
          is_active_(f.node + 1) {
        for (const Node input : inputs) {
            if (input <= f.node) { is_active_[input] = true; }
        }
        for (Node node = 0; node <= f.node; ++node) {
            is_active_[node] = is_active_[node] || depends(node);
        }
        give(f.node, {f.factor, graph.number(1).node});
        for (Node node = f.node + 1; node-- > 0;) {
            if (!shares_[node].empty()) { hand_down(node, total(node)); }
        }
    }

    /// Returns the derivatives by the inputs.
    [[nodiscard]] std::vector<Scaled> totals() const {
        std::vector<Scaled> result;
        for (const Node input : inputs_) { result.push_back(total(input)); }
        return result;
    }

private:
    [[nodiscard]] Scaled total(Node node) const {
        return node < shares_.size() ? graph_.sum(shares_[node]) : graph_.number(0);
    }

    [[nodiscard]] bool depends(Node node) const {
        const Computation& computation = graph_.at(node);
        const auto& [terms, arguments] = std::tie(computation.terms, computation.arguments);
        return std::any_of(terms.begin(), terms.end(),
                           [&](const Scaled& term) { return is_active_[term.node]; }) ||
               std::any_of(arguments.begin(), arguments.end(),
                           [&](Node argument) { return is_active_[argument]; });
    }

    void give(Node node, const Scaled& share) {
        if (is_active_[node]) { shares_[node].push_back(share); }
    }

    void hand_down(Node node, const Scaled& share) {
        // NOTE: a copy, since the graph grows.
        const Computation computation = graph_.at(node);
        if (const auto power = graph_.half_power_at(node)) {
            give(power->base.node, graph_.product(share, of_half_power(*power)));
            return;
        }
        if (chooses(computation)) {
            hand_to_inputs(computation, share);
            return;
        }
        for (const Scaled& term : computation.terms) {
            give(term.node, graph_.times(term.factor, share));
        }
        const std::vector<Node>& arguments = computation.arguments;
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            if (!is_active_[arguments[k]]) { continue; }
            const Scaled derivative = partial(computation, {{1, 1}, node}, k);
            for (const Scaled& part : parts(share)) {
                give(arguments[k], graph_.product(part, derivative));
            }
        }
    }

    [[nodiscard]] static bool chooses(const Computation& computation) {
        return computation.operation == Operation::call && is_choice(computation.name);
    }

    /// Adds the share of a choice to the inputs at once, chosen as the value is. NOTE: 0 times the
    /// derivative of an alternative that is not chosen would be NaN where it has none.
    void hand_to_inputs(const Computation& computation, const Scaled& share) {
        const Computation choice = as_if(computation);
        const Scaled a{{1, 1}, choice.arguments[0]}, b{{1, 1}, choice.arguments[1]};
        const std::vector<Scaled> yes = gradient_of(choice.arguments[2]);
        const std::vector<Scaled> no = gradient_of(choice.arguments[3]);
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            if (inputs_[i] >= shares_.size()) { continue; }
            const Scaled slope = graph_.call(choice.name, {a, b, yes[i], no[i]});
            give(inputs_[i], graph_.product(share, slope));
        }
    }

    /// Returns min and max as `if`.
    [[nodiscard]] Computation as_if(const Computation& computation) {
        if (is_if(computation.name)) { return computation; }
        std::vector<Scaled> arguments;
        for (const Node argument : computation.arguments) {
            arguments.push_back({{1, 1}, argument});
        }
        const Scaled choice = lowered(graph_, find_function(computation.name)->derivative,
                                      arguments, Graph::number(0));
        return graph_.at(choice.node);
    }

    [[nodiscard]] std::vector<Scaled> gradient_of(Node node) {
        const auto known = known_.find(node);
        if (known != known_.end()) { return known->second; }
        const Reverse reverse(graph_, {{1, 1}, node}, inputs_, handed_, known_);
        return known_[node] = reverse.totals();
    }

    /// Returns the terms of a share that is a short polynomial; any other as it is. NOTE: not of a
    /// sum of inputs alone: x - y is the distance of two bodies, and c x - c y would lose its
    /// digits.
    [[nodiscard]] std::vector<Scaled> parts(const Scaled& share) const {
        constexpr std::size_t most = 3;
        const Computation& computation = graph_.at(share.node);
        const std::vector<Scaled>& terms = computation.terms;
        const bool is_polynomial =
            handed_ == Shares::in_terms && !terms.empty() && terms.size() <= most &&
            !std::all_of(terms.begin(), terms.end(),
                         [&](const Scaled& term) { return is_input(term.node); }) &&
            std::all_of(terms.begin(), terms.end(),
                        [&](const Scaled& term) { return is_monomial(term.node); });
        if (!is_polynomial) { return {share}; }
        std::vector<Scaled> result;
        for (const Scaled& term : terms) {
            const auto factor = share.factor * term.factor;
            if (!factor) { return {share}; }
            result.push_back({*factor, term.node});
        }
        return result;
    }

    /// Returns whether a node is a number, an input, or a product of two.
    [[nodiscard]] bool is_monomial(Node node) const {
        const Computation& computation = graph_.at(node);
        const std::vector<Node>& factors = computation.arguments;
        return graph_.is_number({{1, 1}, node}) || is_input(node) ||
               (computation.operation == Operation::product &&
                std::all_of(factors.begin(), factors.end(),
                            [&](Node factor) { return is_input(factor); }));
    }

    [[nodiscard]] bool is_input(Node node) const {
        return graph_.at(node).operation == Operation::input;
    }

    /// Returns the derivative by argument number k.
    [[nodiscard]] Scaled partial(const Computation& computation, const Scaled& value,
                                 std::size_t k) {
        const Scaled a{{1, 1}, computation.arguments.front()};
        const Scaled b{{1, 1}, computation.arguments.back()};
        switch (computation.operation) {
        case Operation::product: return k == 0 ? b : a;
        case Operation::inverse: return graph_.times({-1, 1}, graph_.product(value, value));
        case Operation::square_root: return graph_.times({1, 2}, graph_.half_power(a, -1));
        case Operation::inverse_square_root: return graph_.times({-1, 2}, graph_.half_power(a, -3));
        case Operation::power: return k == 0 ? of_base(a, b) : of_exponent(a, value);
        default: break;
        }
        std::vector<Scaled> arguments;
        for (const Node argument : computation.arguments) {
            arguments.push_back({{1, 1}, argument});
        }
        return derivative(graph_, computation.name, arguments, value, k);
    }

    /// Returns the derivative of a power by the node of its base. NOTE: the rule of products would
    /// give two terms, and the graph does not see that they are equal.
    [[nodiscard]] Scaled of_half_power(const HalfPower& power) {
        const Scaled less = graph_.half_power(power.base, power.twice_exponent - 2);
        return graph_.product(graph_.times({power.twice_exponent, 2}, less),
                              {power.base.factor, graph_.number(1).node});
    }

    [[nodiscard]] Scaled of_base(const Scaled& base, const Scaled& exponent) {
        const Scaled less = graph_.sum({exponent, graph_.number(-1)});
        return graph_.product(exponent, graph_.power(base, less));
    }

    [[nodiscard]] Scaled of_exponent(const Scaled& base, const Scaled& value) {
        return graph_.product(value, graph_.call("log", {base}));
    }

    Graph& graph_;
    const std::vector<Node>& inputs_;
    Shares handed_;
    Gradients& known_;
    std::vector<std::vector<Scaled>> shares_;  ///< terms of the derivative of f by each node
    std::vector<bool> is_active_;              ///< whether a node depends on the inputs
};

}  // namespace

std::vector<Scaled> gradient(Graph& graph, const Scaled& f, const std::vector<Node>& inputs,
                             Shares shares) {
    Gradients known;
    return Reverse(graph, f, inputs, shares, known).totals();
}

}  // namespace hvi::gen
