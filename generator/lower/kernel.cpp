// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/kernel.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace hvi::gen {

namespace {

void count_factor(OperationCounts& counts, const SmallFraction& factor) {
    if (!factor.size().is_one()) { ++counts.multiplications; }
}

void count(const Graph& graph, Kernel& kernel, Node node) {
    OperationCounts& counts = kernel.counts;
    const Computation& computation = graph.at(node);
    switch (computation.operation) {
    case Operation::constant:
    case Operation::input: break;
    case Operation::sum:
        counts.additions += computation.terms.size() - 1;
        for (const Scaled& term : computation.terms) {
            if (!graph.is_number(term)) { count_factor(counts, term.factor); }
        }
        break;
    case Operation::product:
        if (std::none_of(computation.arguments.begin(), computation.arguments.end(),
                         [&](Node argument) { return kernel.is_divisor(argument); })) {
            ++counts.multiplications;
        }
        break;
    case Operation::inverse: ++counts.divisions; break;
    case Operation::inverse_square_root: ++counts.divisions; break;
    case Operation::square_root: break;
    case Operation::power:
    case Operation::call: ++counts.calls; break;
    }
}

/// Returns the number of roots. NOTE: compilers compute sqrt(a) once, also where 1/sqrt(a) is
/// needed.
std::size_t count_roots(const Graph& graph, const Kernel& kernel) {
    std::set<Node> arguments;
    for (const Node node : kernel.nodes) {
        const Computation& computation = graph.at(node);
        const bool is_root = computation.operation == Operation::square_root ||
                             computation.operation == Operation::inverse_square_root;
        if (is_root) { arguments.insert(computation.arguments.front()); }
    }
    return arguments.size();
}

std::vector<Node> divisors(const Graph& graph, const Kernel& kernel) {
    std::vector<Node> result;
    for (const Node node : kernel.nodes) {
        const Operation operation = graph.at(node).operation;
        const bool is_inverse =
            operation == Operation::inverse || operation == Operation::inverse_square_root;
        if (is_inverse && kernel.uses[node] == 1) { result.push_back(node); }
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// Returns the nodes that a node is computed from, with repetitions.
std::vector<Node> operands(const Computation& computation) {
    std::vector<Node> result = computation.arguments;
    for (const Scaled& term : computation.terms) { result.push_back(term.node); }
    return result;
}

/// Orders the nodes so that few values wait for their use: what the results need first, depth
/// first, and after each node at once the nodes that lacked nothing else. So the forces of two
/// bodies on each other are finished before those of the next two begin, and compilers find
/// registers enough.
class Schedule {
public:
    Schedule(const Graph& graph, const std::vector<Node>& nodes)
        : graph_(graph), users_(graph.size()), missing_(graph.size()), is_left_(graph.size()) {
        for (const Node node : nodes) { is_left_[node] = true; }
        for (const Node node : nodes) {
            for (const Node operand : operands(graph.at(node))) {
                if (!is_left_[operand]) { continue; }
                users_[operand].push_back(node);
                ++missing_[node];
            }
        }
    }

    [[nodiscard]] std::vector<Node> order(const std::vector<Scaled>& results) {
        for (const Scaled& result : results) {
            // NOTE: a stack, since graphs are deep.
            std::vector<Node> wanted{result.node};
            while (!wanted.empty()) { take_up(wanted); }
        }
        return std::move(order_);
    }

private:
    /// Puts the last wanted node into the order, or finds the nodes that it needs first.
    void take_up(std::vector<Node>& wanted) {
        const Node node = wanted.back();
        const bool is_ready = missing_[node] == 0;
        if (is_ready || !is_left_[node]) { wanted.pop_back(); }
        if (!is_left_[node]) { return; }
        std::vector<Node> next;
        if (is_ready) {
            is_left_[node] = false;
            order_.push_back(node);
            for (const Node user : users_[node]) {
                if (--missing_[user] == 0) { next.push_back(user); }
            }
        } else {
            next = operands(graph_.at(node));
        }
        wanted.insert(wanted.end(), next.rbegin(), next.rend());
    }

    const Graph& graph_;
    std::vector<std::vector<Node>> users_;
    std::vector<std::size_t> missing_;  // operands that are not in order_ yet
    std::vector<bool> is_left_;         // to be put into order_
    std::vector<Node> order_;
};

template <class IsGiven>
Kernel kernel(const Graph& graph, std::vector<Scaled> results, IsGiven is_given) {
    Kernel kernel;
    kernel.uses.resize(graph.size());
    for (const Scaled& result : results) { ++kernel.uses[result.node]; }
    for (auto node = static_cast<Node>(graph.size()); node-- > 0;) {
        if (kernel.uses[node] == 0) { continue; }
        const Computation& computation = graph.at(node);
        if (is_given(computation)) {
            kernel.given.push_back(node);
            continue;
        }
        kernel.nodes.push_back(node);
        for (const Node operand : operands(computation)) { ++kernel.uses[operand]; }
    }
    std::reverse(kernel.given.begin(), kernel.given.end());
    std::reverse(kernel.nodes.begin(), kernel.nodes.end());
    kernel.nodes = Schedule(graph, kernel.nodes).order(results);
    kernel.divisors = divisors(graph, kernel);
    for (const Node node : kernel.nodes) { count(graph, kernel, node); }
    kernel.counts.square_roots = count_roots(graph, kernel);
    for (const Scaled& result : results) {
        if (!graph.is_number(result)) { count_factor(kernel.counts, result.factor); }
    }
    kernel.results = std::move(results);
    return kernel;
}

/// Returns the kernel of values that depend on inputs of that role.
Kernel kernel_of(Role role, const Graph& graph, std::vector<Scaled> results) {
    return kernel(graph, std::move(results), [&](const Computation& computation) {
        return computation.operation == Operation::input || !has(computation.roles, role);
    });
}

}  // namespace

Kernel kernel(const Graph& graph, std::vector<Scaled> results) {
    return kernel(graph, std::move(results), [](const Computation& computation) {
        return computation.operation == Operation::input || !varies(computation.roles);
    });
}

Kernel kernel_of_inputs(const Graph& graph, std::vector<Scaled> results) {
    return kernel(graph, std::move(results), [](const Computation& computation) {
        return computation.operation == Operation::input ||
               computation.operation == Operation::constant;
    });
}

Kernel kernel_of_direction(const Graph& graph, std::vector<Scaled> results) {
    return kernel_of(Role::direction, graph, std::move(results));
}

Kernel kernel_of_momenta(const Graph& graph, std::vector<Scaled> results) {
    return kernel_of(Role::conjugate, graph, std::move(results));
}

OperationCounts& OperationCounts::operator+=(const OperationCounts& more) {
    additions += more.additions;
    multiplications += more.multiplications;
    divisions += more.divisions;
    square_roots += more.square_roots;
    calls += more.calls;
    return *this;
}

double cost(const OperationCounts& counts) {
    return static_cast<double>(counts.additions + counts.multiplications) +
           cost_of_division * static_cast<double>(counts.divisions) +
           cost_of_root * static_cast<double>(counts.square_roots) +
           cost_of_call * static_cast<double>(counts.calls);
}

bool Kernel::is_divisor(Node node) const {
    return std::binary_search(divisors.begin(), divisors.end(), node);
}

}  // namespace hvi::gen
