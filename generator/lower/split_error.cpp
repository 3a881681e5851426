// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/split_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/lower/derivative.hpp"
#include "generator/lower/flow.hpp"
#include "generator/lower/values_in_doubles.hpp"
#include "generator/lower/turns.hpp"
#include "generator/scene/start.hpp"

namespace hvi::gen {

namespace {

/// Brackets of Poisson, and where bodies turn of Lie and Poisson, as nodes of the graph.
class BracketsInGraph {
public:
    explicit BracketsInGraph(System& system)
        : system_(system), q_(coordinate_nodes(system)), p_(conjugate_nodes(system)) {}

    [[nodiscard]] Scaled sum(std::vector<Scaled> terms) {
        return system_.graph.sum(std::move(terms));
    }

    /// Returns {I, G}, the derivative of I along the flow of G.
    [[nodiscard]] Scaled operator()(const Scaled& I, const Scaled& G) {
        const Slopes of_I = slopes(I), of_G = slopes(G);
        Graph& graph = system_.graph;
        std::vector<Scaled> terms;
        for (std::size_t k = 0; k < p_.size(); ++k) {
            terms.push_back(graph.product(of_I.by_q[k], of_G.by_p[k]));
            terms.push_back(negative(graph.product(of_I.by_p[k], of_G.by_q[k])));
        }
        const std::size_t flat = flat_coordinates(system_);
        for (std::size_t first = flat; first < p_.size(); first += 3)
            for (std::size_t a = 0; a < 3; ++a) {
                const std::size_t k = first + a, b = first + (a + 1) % 3, c = first + (a + 2) % 3;
                const Scaled turned =
                    graph.sum({graph.product({{1, 1}, p_[b]}, of_G.by_p[c]),
                               negative(graph.product({{1, 1}, p_[c]}, of_G.by_p[b]))});
                terms.push_back(graph.product(of_I.by_p[k], turned));
            }
        return graph.sum(std::move(terms));
    }

private:
    /// Derivatives by degrees of freedom and by conjugates.
    struct Slopes {
        std::vector<Scaled> by_q, by_p;
    };

    [[nodiscard]] Slopes slopes(const Scaled& value) {
        std::vector<Scaled> by_p = gradient(system_.graph, value, p_);
        return {by_turns(system_, gradient(system_.graph, value, q_)), std::move(by_p)};
    }

    [[nodiscard]] Scaled negative(const Scaled& value) {
        return system_.graph.times({-1, 1}, value);
    }

    System& system_;
    std::vector<Node> q_, p_;
};

constexpr std::size_t steps_of_motion = 128, most_parts = 4096;
constexpr std::size_t most_attempts = 4;  ///< with distances of a quarter each
constexpr double most_change = 1e-3;      ///< of the energy, in parts of the size of H
constexpr double error_of_steps = 0.01;
constexpr double cost_of_exact_sum = 7;  ///< of a change and a variable, with what is rounded off

double as_number(const Ball& ball) { return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR); }

/// Returns the values of all parameters.
InputValues parameters_of(const WrittenOutScene& scene) {
    InputValues values;
    for (const auto& [name, value] : parameter_values(scene)) { values[name] = as_number(value); }
    return values;
}

/// Returns coordinates, then conjugates, at the start.
std::vector<double> start_of_motion(const WrittenOutScene& scene) {
    const SymbolValues parameters = parameter_values(scene);
    std::vector<double> state;
    for (const NamedExpression& each : scene.initial) {
        state.push_back(as_number(value_at(each.expression, parameters, each.place.source)));
    }
    return state;
}

/// Returns coordinates, then conjugates.
std::vector<Node> variable_nodes(const System& system) {
    std::vector<Node> nodes = coordinate_nodes(system);
    for (const Node node : conjugate_nodes(system)) { nodes.push_back(node); }
    return nodes;
}

/// Values of a system at a state.
class ValuesAtStates {
public:
    ValuesAtStates(const System& system, const WrittenOutScene& scene)
        : system_(system), inputs_(parameters_of(scene)), variables_(variable_nodes(system)) {}

    [[nodiscard]] std::vector<double> operator()(const std::vector<Scaled>& results,
                                                 const std::vector<double>& state) {
        for (std::size_t k = 0; k < variables_.size(); ++k) {
            inputs_[system_.graph.at(variables_[k]).name] = state[k];
        }
        return values_at(system_.graph, results, inputs_);
    }

private:
    const System& system_;
    InputValues inputs_;
    std::vector<Node> variables_;
};

/// Returns for each part but the last {A, {A, B}} and {B, {B, A}}.
std::vector<Scaled> nested_brackets(System& system) {
    const std::vector<HamiltonianPart> parts = system.parts.value().parts;
    BracketsInGraph bracket(system);
    std::vector<Scaled> nested;
    Scaled rest = parts.back().value;
    for (std::size_t k = parts.size() - 1; k-- > 0;) {
        const Scaled& A = parts[k].value;
        const Scaled AB = bracket(A, rest);
        nested.push_back(bracket(A, AB));
        nested.push_back(system.graph.times({-1, 1}, bracket(rest, AB)));
        rest = bracket.sum({A, rest});
    }
    return nested;
}

/// Returns the derivatives of all variables along the motion.
std::vector<Scaled> rates_of(System& system) {
    std::vector<Scaled> parts;
    for (const HamiltonianPart& part : system.parts->parts) { parts.push_back(part.value); }
    const Scaled H = system.graph.sum(std::move(parts));
    BracketsInGraph bracket(system);
    std::vector<Scaled> rates;
    for (const Node node : variable_nodes(system)) { rates.push_back(bracket({{1, 1}, node}, H)); }
    return rates;
}

/// Returns the state after a step of the classical Runge-Kutta method.
std::vector<double> after_step(ValuesAtStates& values, const std::vector<Scaled>& rates, double h,
                               const std::vector<double>& state) {
    constexpr double nodes[] = {0, 0.5, 0.5, 1}, weights[] = {1, 2, 2, 1};
    std::vector<double> result = state, slopes(state.size());
    for (std::size_t i = 0; i < 4; ++i) {
        std::vector<double> stage = state;
        for (std::size_t k = 0; k < state.size(); ++k) { stage[k] += h * nodes[i] * slopes[k]; }
        slopes = values(rates, stage);
        for (std::size_t k = 0; k < state.size(); ++k) {
            result[k] += h / 6 * weights[i] * slopes[k];
        }
    }
    return result;
}

/// Returns the sum of |A|.
double size_of_parts(const System& system, ValuesAtStates& values,
                     const std::vector<double>& state) {
    std::vector<Scaled> parts;
    for (const HamiltonianPart& part : system.parts->parts) { parts.push_back(part.value); }
    double sum = 0;
    for (const double value : values(parts, state)) { sum += std::abs(value); }
    return sum;
}

double norm(const std::vector<double>& vector) {
    double sum = 0;
    for (const double each : vector) { sum += each * each; }
    return std::sqrt(sum);
}

/// Returns the step in which strang has an error of about a hundredth by its brackets at the start,
/// but at most half the time in which the state would change by its size.
double distance_of_states(ValuesAtStates& values, const std::vector<Scaled>& nested,
                          const std::vector<Scaled>& rates, const std::vector<double>& start,
                          const System& system) {
    double sizes = 0;
    for (const double bracket : values(nested, start)) { sizes += std::abs(bracket) / 12; }
    const double of_error =
        std::sqrt(error_of_steps * size_of_parts(system, values, start) / sizes);
    return std::min(of_error, norm(start) / (2 * norm(values(rates, start))));
}

/// The motion from a start, by steps of the classical Runge-Kutta method.
class MotionInSteps {
public:
    MotionInSteps(const System& system, ValuesAtStates& values, const std::vector<Scaled>& rates,
                  const std::vector<double>& start)
        : values_(values),
          rates_(rates),
          start_(start),
          size_(size_of_parts(system, values, start)) {
        for (const HamiltonianPart& part : system.parts->parts) { parts_.push_back(part.value); }
        energy_ = energy(start);
    }

    /// Returns the start and states at distances h; nothing where the energy does not stay, as the
    /// method does not follow the motion.
    [[nodiscard]] std::optional<StatesOfMotion> operator()(double h) {
        StatesOfMotion states{start_};
        for (std::size_t step = 0; step < steps_of_motion; ++step) {
            auto state = after(states.back(), h);
            if (!state) { return {}; }
            states.push_back(*std::move(state));
        }
        return states;
    }

private:
    /// Returns the state after a time, in so many steps that the energy stays.
    [[nodiscard]] std::optional<std::vector<double>> after(const std::vector<double>& start,
                                                           double time) {
        for (std::size_t parts = 4; parts <= most_parts; parts *= 4) {
            std::vector<double> state = start;
            for (std::size_t part = 0; part < parts; ++part) {
                state = after_step(values_, rates_, time / static_cast<double>(parts), state);
            }
            if (std::abs(energy(state) - energy_) < most_change * size_) { return state; }
        }
        return {};
    }

    [[nodiscard]] double energy(const std::vector<double>& state) {
        double sum = 0;
        for (const double value : values_(parts_, state)) { sum += value; }
        return sum;
    }

    ValuesAtStates& values_;
    const std::vector<Scaled>& rates_;
    const std::vector<double>& start_;
    std::vector<Scaled> parts_;
    double size_, energy_ = 0;
};

}  // namespace

std::optional<double> split_error(System system, const WrittenOutScene& scene,
                                  const StatesOfMotion& states) {
    const std::vector<Scaled> nested = nested_brackets(system);
    ValuesAtStates values(system, scene);
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const std::vector<double>& state : states) {
        const std::vector<double> brackets = values(nested, state);
        double error = 0;
        for (std::size_t k = 0; k < brackets.size(); k += 2) {
            error += brackets[k + 1] / 12 - brackets[k] / 24;
        }
        if (!std::isfinite(error)) { return {}; }
        least = std::min(least, error);
        most = std::max(most, error);
    }
    const double size = size_of_parts(system, values, states.front());
    if (!(size > 0) || !std::isfinite(size)) { return {}; }
    return (most - least) / size;
}

std::optional<StatesOfMotion> states_of_motion(System system, const WrittenOutScene& scene) {
    if (scene.initial.empty()) { return {}; }
    const std::vector<Scaled> nested = nested_brackets(system), rates = rates_of(system);
    ValuesAtStates values(system, scene);
    const std::vector<double> start = start_of_motion(scene);
    MotionInSteps motion(system, values, rates, start);
    double h = distance_of_states(values, nested, rates, start, system);
    if (!std::isfinite(h) || !(h > 0)) { return {}; }
    for (std::size_t k = 0; k < most_attempts; ++k) {
        if (auto states = motion(h)) { return states; }
        h /= 4;
    }
    return {};
}

double cost_of_strang(const System& system) {
    const std::vector<HamiltonianPart>& parts = system.parts.value().parts;
    double sum = 0;
    for (const HamiltonianPart& part : parts) {
        const bool is_made_once = &part == &parts.front() || &part == &parts.back();
        const double of_sums = cost_of_exact_sum * static_cast<double>(numbers_moved(part));
        const double of_flow = of_sums + cost(counts_of_flow(system.graph, part));
        sum += (is_made_once ? 1 : 2) * of_flow;
    }
    return sum;
}

}  // namespace hvi::gen
