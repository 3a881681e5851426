// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/lowered_events.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/event_slope.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {
namespace {

class EventLowering {
public:
    EventLowering(const System& system, const WrittenOutScene& scene)
        : system_(system), scene_(scene) {
        result_.graph = system.graph;
        result_.time = system.time;
        name_variables();
        find_motion();
        for (const SystemParameter& parameter : system.parameters) {
            symbols_[parameter.name] = {{1, 1}, parameter.node};
        }
        for (const Parameter& parameter : scene.parameters) {
            if (symbols_.count(parameter.name) != 0) { continue; }
            symbols_[parameter.name] = lower(result_.graph, parameter.value, {}, parameter.source);
        }
    }

    [[nodiscard]] LoweredEvents operator()() {
        for (const SceneEvent& event : scene_.events) { result_.events.push_back(lowered(event)); }
        return std::move(result_);
    }

private:
    void name_variables() {
        names_ = variables(scene_);
        std::vector<Node> nodes = coordinate_nodes(system_);
        result_.degrees = nodes.size();
        const std::vector<Node> conjugates = conjugate_nodes(system_);
        nodes.insert(nodes.end(), conjugates.begin(), conjugates.end());
        for (std::size_t k = 0; k < names_.size(); ++k) {
            symbols_[names_[k]] = {{1, 1}, nodes.at(k)};
            result_.variables.push_back({k, nodes.at(k)});
        }
    }

    /// Gives the time a name. NOTE: the function alone may not depend on the time.
    void name_time(const Expression& expression) {
        walk(expression, [&](const Expression& part) {
            if (part.kind == Expression::Kind::symbol && part.name == "t" &&
                symbols_.count("t") == 0) {
                symbols_["t"] = result_.graph.input("t", Role::time);
                result_.time = symbols_["t"].node;
            }
            return true;
        });
    }

    [[nodiscard]] Scaled value(const NamedExpression& written) {
        name_time(written.expression);
        const Scaled result =
            lower(result_.graph, written.expression, symbols_, written.place.source);
        if (system_.side == Side::lagrangian && !result_.velocities) {
            check_event_of_L(result_.graph, result, written.place);
        }
        return result;
    }

    [[nodiscard]] std::optional<LoweredSpan> span(const std::optional<NamedExpression>& written) {
        if (!written) { return {}; }
        return LoweredSpan{value(*written), written->place};
    }

    [[nodiscard]] LoweredEvent lowered(const SceneEvent& event) {
        LoweredEvent result{.name = event.name,
                            .direction = event.direction,
                            .stop = event.stop,
                            .is_kink = event.is_kink,
                            .zero = value(event.zero)};
        if (!result_.motion.empty()) { differentiate(result_, result); }
        if (system_.side == Side::lagrangian && !event.set.empty()) {
            refuse_set_of_L(event.set.front().place);
        }
        for (const NamedExpression& jump : event.set) {
            const auto name = std::find(names_.begin(), names_.end(), jump.name);
            result.set.push_back({static_cast<std::size_t>(name - names_.begin()), value(jump)});
        }
        if (system_.scaled && !result.set.empty()) { result.set.push_back(jump_of_e(result.set)); }
        result.cooldown = span(event.cooldown);
        result.period = span(event.period);
        return result;
    }

    /// Returns the momentum of the time after a jump, which keeps H + e at 0.
    [[nodiscard]] LoweredJump jump_of_e(const std::vector<LoweredJump>& set) {
        Symbols after = symbols_;
        for (const LoweredJump& jump : set) { after[names_[jump.variable]] = jump.value; }
        after[names_.back()] = Graph::number(0);
        const Scaled energy =
            lower(result_.graph, system_.scaled->energy, after, function_of(scene_).source);
        return {names_.size() - 1, result_.graph.times({-1, 1}, energy)};
    }

    /// Finds the derivatives along the motion. NOTE: functions of the user's own have no
    /// derivatives here, and rotations have no numbers that H is differentiated by.
    void find_motion() {
        if (rotations_of(system_) != 0 || !system_.own_headers.empty()) { return; }
        const bool is_of_L = system_.side == Side::lagrangian;
        if (is_of_L) { find_velocities(); }
        const std::vector<Scaled> by_q = by_coordinates(system_), by_p = by_conjugates(system_);
        for (std::size_t k = 0; k < by_q.size(); ++k) {
            result_.motion[k] =
                is_of_L ? Scaled{{1, 1}, result_.velocities->velocities[k]} : by_p[k];
            result_.motion[result_.degrees + k] =
                is_of_L ? by_q[k] : result_.graph.times({-1, 1}, by_q[k]);
        }
    }

    /// Makes velocities what the momenta of a state are solved for.
    void find_velocities() {
        Graph& graph = result_.graph;
        LoweredVelocities& solved = result_.velocities.emplace();
        solved.velocities = conjugate_nodes(system_);
        solved.momenta = by_conjugates(system_);
        for (const std::vector<Scaled>& row : hessian_of(system_).conjugates) {
            solved.mass.insert(solved.mass.end(), row.begin(), row.end());
        }
        for (const Node velocity : solved.velocities) {
            const std::string name = "weight of " + graph.at(velocity).name;
            solved.weights.push_back(graph.input(name, Role::direction).node);
        }
        std::erase_if(result_.variables,
                      [&](const EventVariable& each) { return each.number >= result_.degrees; });
    }

    const System& system_;
    const WrittenOutScene& scene_;
    LoweredEvents result_;
    Symbols symbols_;
    std::vector<std::string> names_;  ///< of variables
};

}  // namespace

void check_event_of_L(const Graph& graph, const Scaled& value, const Place& place) {
    if (!has(graph.at(value.node).roles, Role::conjugate)) { return; }
    throw InputError("here events of a Lagrangian are functions of coordinates and the time", place,
                     "with momenta it is one of the Hamiltonian, which `hvi-gen scheme` prints");
}

void refuse_set_of_L(const Place& place) {
    throw InputError("events of a Lagrangian set nothing", place,
                     "write the Hamiltonian, which `hvi-gen scheme` prints");
}

LoweredEvents lowered_events(const System& system, const WrittenOutScene& scene) {
    return EventLowering(system, scene)();
}

}  // namespace hvi::gen
