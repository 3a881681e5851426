// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "generator/graph/written.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/flows.hpp"
#include "generator/lower/lower.hpp"
#include "generator/lower/taken_names.hpp"

namespace hvi::gen {

namespace {

/// Returns the values of all words in the expressions of a scene.
Symbols symbols_of(System& system, const WrittenOutScene& scene) {
    Symbols symbols;
    for (const Parameter& parameter : scene.parameters) {
        symbols[parameter.name] = lower(system.graph, parameter.value, {}, parameter.place.source);
    }
    for (Node node = 0; node < system.graph.size(); ++node) {
        const Computation& computation = system.graph.at(node);
        if (computation.operation == Operation::input) {
            symbols[computation.name] = {{1, 1}, node};
        }
    }
    return symbols;
}

/// Adds the terms of a value times a factor that does not vary.
void add_terms(Graph& graph, const Scaled& value, const Scaled& factor,
               std::vector<Scaled>& terms) {
    const Computation computation = graph.at(value.node);  // a copy, since the graph grows
    const Scaled scaled = graph.times(value.factor, factor);
    if (computation.operation == Operation::sum) {
        for (const Scaled& term : computation.terms) { add_terms(graph, term, scaled, terms); }
        return;
    }
    if (computation.operation == Operation::product) {
        const Scaled a{{1, 1}, computation.arguments[0]}, b{{1, 1}, computation.arguments[1]};
        const bool is_fixed_a = !varies(graph.at(a.node).roles);
        const bool is_fixed_b = !varies(graph.at(b.node).roles);
        if (is_fixed_a != is_fixed_b) {
            return add_terms(graph, is_fixed_a ? b : a, graph.product(scaled, is_fixed_a ? a : b),
                             terms);
        }
    }
    terms.push_back(graph.product(scaled, {{1, 1}, value.node}));
}

/// Returns the expression, or what stands for a long one.
Expression expression_of(const Graph& graph, const Scaled& value) {
    return written(graph, value).value_or(Expression::symbol(too_long_part));
}

bool is_of_time(const Graph& graph, const Scaled& value) {
    return has(graph.at(value.node).roles, Role::time);
}

class PartsOfSystem {
public:
    PartsOfSystem(System system, const WrittenOutScene& scene)
        : system_(std::move(system)), scene_(scene) {
        std::set<std::string> taken = taken_names(system_);
        parts_.duration = system_.graph.input(new_name("tau", taken), Role::parameter).node;
    }

    [[nodiscard]] System operator()(FoundParts found) && {
        if (scene_.split) {
            read_parts(*scene_.split);
        } else if (found == FoundParts::kinetic_potential) {
            set_kinetic_and_potential();
        } else {
            find_parts(found == FoundParts::by_terms);
        }
        if (system_.time) { set_clock(system_.graph, parts_); }
        system_.parts = std::move(parts_);
        return std::move(system_);
    }

private:
    /// Adds the parts that the scene names. NOTE: of terms with roots, equal ones vanish as nodes.
    void read_parts(const SceneSplit& split) {
        const Symbols symbols = symbols_of(system_, scene_);
        std::vector<Scaled> rest;
        add_terms(system_.graph, function_of(system_), Graph::number(1), rest);
        for (const NamedExpression& part : split.parts) {
            const Scaled value = lower(system_.graph, part.expression, symbols, part.place.source);
            add_terms(system_.graph, value, Graph::number(-1), rest);
            auto flow = flow_of(system_, value, parts_.duration);
            if (const auto* none = std::get_if<NoFlow>(&flow)) {
                throw MathError(
                    fmt::format("the flow of `{}` is not known: {}", part.name, none->reason),
                    part.place, help_for_flows);
            }
            add(part.name, part.expression, value, std::get<Flow>(std::move(flow)));
        }
        parts_.small_steps = split.small_steps;
        check_sum(system_.graph.sum(std::move(rest)), split.place);
    }

    void check_sum(const Scaled& rest, const Place& place) {
        const auto constant = constant_value(system_.graph, rest);
        if (constant && constant->is_zero()) { return; }
        const auto difference = written(system_.graph, rest);
        throw InputError("the parts do not add up to the Hamiltonian", place,
                         difference ? fmt::format("H minus their sum is {}", to_text(*difference))
                                    : "their sum has to be H");
    }

    /// Adds parts that are found among the terms of H. NOTE: the time is to go on with a part that
    /// does not depend on it.
    void find_parts(bool may_take_matrices) {
        std::vector<Scaled> sums;
        std::vector<Flow> flows;
        for (const Scaled& term : terms()) {
            std::size_t k = 0;
            for (; k < sums.size(); ++k) {
                if (is_of_time(system_.graph, sums[k]) != is_of_time(system_.graph, term)) {
                    continue;
                }
                const Scaled sum = system_.graph.sum({sums[k], term});
                auto flow = flow_of(system_, sum, parts_.duration);
                auto* known = std::get_if<Flow>(&flow);
                if (known == nullptr) { continue; }
                if (!may_take_matrices && known->forms.size() > flows[k].forms.size()) { continue; }
                sums[k] = sum;
                flows[k] = std::move(*known);
                break;
            }
            if (k < sums.size()) { continue; }
            sums.push_back(term);
            flows.push_back(flow_of_term(term));
        }
        for (std::size_t k = 0; k < sums.size(); ++k) {
            add(name_of_part(k), expression_of(system_.graph, sums[k]), sums[k],
                std::move(flows[k]));
        }
    }

    /// Adds T(p) and U(q).
    void set_kinetic_and_potential() {
        std::vector<Scaled> of_p, of_q;
        for (const Scaled& term : terms()) {
            const bool is_of_p = has(system_.graph.at(term.node).roles, Role::conjugate);
            (is_of_p ? of_p : of_q).push_back(term);
        }
        for (std::vector<Scaled>* all : {&of_p, &of_q}) {
            if (all->empty()) { continue; }
            const Scaled sum = system_.graph.sum(std::move(*all));
            add(name_of_part(parts_.parts.size()), expression_of(system_.graph, sum), sum,
                flow_of_term(sum));
        }
    }

    /// Returns the terms of H that vary. NOTE: a part has its flow with all functions of q alone or
    /// with none, but where they are quadratic, and so these are one term: there may be thousands.
    [[nodiscard]] std::vector<Scaled> terms() {
        std::vector<Scaled> all, result, of_q;
        add_terms(system_.graph, function_of(system_), Graph::number(1), all);
        for (const Scaled& term : all) {
            const Roles roles = system_.graph.at(term.node).roles;
            if (!varies(roles)) { continue; }
            const bool is_of_q = !has(roles, Role::conjugate) && !is_monomial(term.node);
            (is_of_q ? of_q : result).push_back(term);
        }
        if (!of_q.empty()) { result.push_back(system_.graph.sum(std::move(of_q))); }
        return result;
    }

    /// Returns whether a node is a product of two variables at most, and of what does not vary.
    [[nodiscard]] bool is_monomial(Node node) const {
        const auto is_input = [&](Node one) {
            return system_.graph.at(one).operation == Operation::input;
        };
        if (is_input(node)) { return true; }
        const Computation& computation = system_.graph.at(node);
        if (computation.operation != Operation::product) { return false; }
        const Node a = computation.arguments[0], b = computation.arguments[1];
        if (!varies(system_.graph.at(a).roles)) { return is_monomial(b); }
        if (!varies(system_.graph.at(b).roles)) { return is_monomial(a); }
        return is_input(a) && is_input(b);
    }

    [[nodiscard]] Flow flow_of_term(const Scaled& term) {
        auto flow = flow_of(system_, term, parts_.duration);
        if (auto* known = std::get_if<Flow>(&flow)) { return std::move(*known); }
        const std::string text = to_text(expression_of(system_.graph, term));
        throw MathError(
            fmt::format("no splitting of this H is found: the flow of {} is not known", text),
            whole(function_of(scene_).source),
            "name parts in a section [split], or take an implicit method: gauss:2");
    }

    void add(std::string name, Expression expression, const Scaled& value, Flow flow) {
        parts_.parts.push_back({std::move(name), std::move(expression), std::move(flow.kind),
                                std::move(flow.moved), std::move(flow.usual),
                                std::move(flow.in_each_flow), std::move(flow.forms), value});
    }

    static constexpr const char* help_for_flows =
        "known are functions of variables that they do not move, quadratic forms of one degree of "
        "freedom, functions of sums of these, quadratic forms that couple up to 8 degrees, Kepler "
        "orbits that do not couple, functions of one component of an angular momentum, and free "
        "symmetric bodies";

    System system_;
    const WrittenOutScene& scene_;
    HamiltonianParts parts_;
};

}  // namespace

std::string name_of_part(std::size_t k) {
    constexpr std::size_t letters = 26;
    return k < letters ? std::string(1, static_cast<char>('A' + k)) : fmt::format("P{}", k + 1);
}

void set_clock(const Graph& graph, HamiltonianParts& parts) {
    std::vector<HamiltonianPart>& all = parts.parts;
    const auto found = std::find_if(all.begin(), all.end(), [&](const HamiltonianPart& part) {
        return !is_of_time(graph, part.value);
    });
    parts.clock = static_cast<std::size_t>(found - all.begin());
    if (found != all.end()) { return; }
    HamiltonianPart time{"t", Expression::integer(0), "the time alone", {}, {}};
    time.value = Graph::number(0);
    time.text = "the momentum of the time";
    all.push_back(std::move(time));
}

System with_parts(System system, const WrittenOutScene& scene, FoundParts found) {
    return PartsOfSystem(std::move(system), scene)(found);
}

}  // namespace hvi::gen
