// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/graph/replaced.hpp"

#include <utility>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

class Replacing {
public:
    Replacing(Graph& graph, const std::map<Node, Scaled>& inputs,
              const std::map<Node, Scaled>& forms)
        : graph_(graph), known_(inputs), forms_(forms) {}

    [[nodiscard]] Scaled operator()(const Scaled& a) { return graph_.times(a.factor, at(a.node)); }

private:
    [[nodiscard]] Scaled at(Node node) {
        const auto found = known_.find(node);
        if (found != known_.end()) { return found->second; }
        const auto form = forms_.find(node);
        const Scaled result = form != forms_.end() ? (*this)(form->second) : made_anew(node);
        known_.emplace(node, result);
        return result;
    }

    /// NOTE: a node without changes stays the same, also where it is a number times a parameter.
    [[nodiscard]] Scaled made_anew(Node node) {
        // NOTE: a copy, since the graph grows.
        const Computation computation = graph_.at(node);
        std::vector<Scaled> arguments;
        bool is_same = true;
        const auto add = [&](const Scaled& before) {
            arguments.push_back((*this)(before));
            is_same = is_same && arguments.back() == before;
        };
        for (const Scaled& term : computation.terms) { add(term); }
        for (const Node argument : computation.arguments) { add({{1, 1}, argument}); }
        return is_same ? Scaled{{1, 1}, node} : made_of(computation, std::move(arguments));
    }

    [[nodiscard]] Scaled made_of(const Computation& computation, std::vector<Scaled> arguments) {
        switch (computation.operation) {
        case Operation::sum: return graph_.sum(std::move(arguments));
        case Operation::product: return graph_.product(arguments[0], arguments[1]);
        case Operation::inverse: return graph_.inverse(arguments[0]);
        case Operation::square_root: return graph_.half_power(arguments[0], 1);
        case Operation::inverse_square_root: return graph_.half_power(arguments[0], -1);
        case Operation::power: return graph_.power(arguments[0], arguments[1]);
        case Operation::call: return graph_.call(computation.name, arguments);
        case Operation::constant:
        case Operation::input: break;
        }
        HVI_CHECK(false);
        return {};
    }

    Graph& graph_;
    std::map<Node, Scaled> known_;
    const std::map<Node, Scaled>& forms_;
};

}  // namespace

Scaled replaced(Graph& graph, const Scaled& value, const std::map<Node, Scaled>& inputs) {
    return Replacing(graph, inputs, {})(value);
}

std::vector<Scaled> rewritten(Graph& graph, std::vector<Scaled> values,
                              const std::map<Node, Scaled>& forms) {
    Replacing replacing(graph, {}, forms);
    for (Scaled& value : values) { value = replacing(value); }
    return values;
}

}  // namespace hvi::gen
