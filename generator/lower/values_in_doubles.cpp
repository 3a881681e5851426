// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/values_in_doubles.hpp"

#include <cmath>
#include <unordered_map>

#include "generator/expr/own_functions.hpp"
#include "generator/graph/written.hpp"
#include "generator/scene/value_at.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

double as_double(const SmallFraction& fraction) {
    return static_cast<double>(fraction.above) / static_cast<double>(fraction.below);
}

class DoublesOfNodes {
public:
    DoublesOfNodes(const Graph& graph, const InputValues& inputs)
        : graph_(graph), inputs_(inputs) {}

    [[nodiscard]] double of(const Scaled& value) {
        return as_double(value.factor) * at(value.node);
    }

private:
    [[nodiscard]] double at(Node node) {
        const auto known = values_.find(node);
        if (known != values_.end()) { return known->second; }
        const double value = computed(graph_.at(node));
        values_[node] = value;
        return value;
    }

    [[nodiscard]] double computed(const Computation& computation) {
        const auto argument = [&](std::size_t k) { return at(computation.arguments[k]); };
        switch (computation.operation) {
        case Operation::input: return inputs_.at(computation.name);
        case Operation::sum: {
            double sum = 0;
            for (const Scaled& term : computation.terms) { sum += of(term); }
            return sum;
        }
        case Operation::product: return argument(0) * argument(1);
        case Operation::inverse: return 1 / argument(0);
        case Operation::square_root: return std::sqrt(argument(0));
        case Operation::inverse_square_root: return 1 / std::sqrt(argument(0));
        case Operation::constant: return nearest(computation.constant, {});
        case Operation::power:
        case Operation::call: break;
        }
        return called(computation);
    }

    /// Returns the value of a function or a power. NOTE: by enclosures, as libraries of C++ differ,
    /// and there are none of a function of the user's own.
    [[nodiscard]] double called(const Computation& computation) {
        const bool is_call = computation.operation == Operation::call;
        if (is_call && is_own_function(computation.name)) { return std::nan(""); }
        SymbolValues values;
        std::vector<Expression> symbols;
        for (const Node argument : computation.arguments) {
            const double value = at(argument);
            if (!std::isfinite(value)) { return std::nan(""); }
            const std::string name = "a" + std::to_string(symbols.size());
            arb_set_d(values[name].get(), value);
            symbols.push_back(Expression::symbol(name));
        }
        return nearest(of_operation(computation, std::move(symbols)), values);
    }

    [[nodiscard]] static double nearest(const Expression& expression, const SymbolValues& values) {
        try {
            const Ball value = value_at(expression, values, nullptr);
            return arf_get_d(arb_midref(value.get()), ARF_RND_NEAR);
        } catch (const MathError&) { return std::nan(""); }
    }

    const Graph& graph_;
    const InputValues& inputs_;
    std::unordered_map<Node, double> values_;
};

}  // namespace

std::vector<double> values_at(const Graph& graph, const std::vector<Scaled>& results,
                              const InputValues& inputs) {
    DoublesOfNodes doubles(graph, inputs);
    std::vector<double> values;
    for (const Scaled& result : results) { values.push_back(doubles.of(result)); }
    return values;
}

}  // namespace hvi::gen
