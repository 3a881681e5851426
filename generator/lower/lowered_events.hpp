// Events of a scene in the graph of its system.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/expr/event_direction.hpp"
#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// A new value of a variable.
struct LoweredJump {
    std::size_t variable;  ///< its number among coordinates, then conjugates
    Scaled value;
};

/// A time, or a period, as a function of parameters.
struct LoweredSpan {
    Scaled value;
    Place place;  ///< its place in the text
};

/// A derivative of an event by a variable.
struct SlopeOfEvent {
    std::size_t number;  ///< of the variable, among coordinates, then conjugates
    Scaled value;
};

struct LoweredEvent {
    std::string name;
    EventDirection direction = EventDirection::both;
    long stop = 0;
    bool is_kink = false;  ///< whether it is a kink of H, which ends a step there
    Scaled zero;
    /// The derivative along the motion, {zero, H} plus the derivative by the time. None for
    /// rotations, where functions of the user's own are called, and for many loops.
    std::optional<Scaled> slope = {};
    /// The derivatives of `zero` by q and p, zeros left out; none where there is no slope.
    std::vector<SlopeOfEvent> by_variables = {};
    Scaled by_time = {{0, 1}, 0};
    std::vector<Scaled> by_velocities = {};  ///< at constant q; none where it depends on none
    std::vector<LoweredJump> set = {};
    std::optional<LoweredSpan> cooldown = {}, period = {};
};

/// A variable that events depend on.
struct EventVariable {
    std::size_t number;  ///< among coordinates, then conjugates
    Node node;
};

/// Velocities of an L that is quadratic in them. They are inputs of the graph, and solve
///
///     M v = p - dL/dv(q, 0, t), where M = d2L/dv2.
struct LoweredVelocities {
    std::vector<Node> velocities;
    std::vector<Scaled> momenta;  ///< dL/dv
    std::vector<Scaled> mass;     ///< M, row by row
    std::vector<Node> weights;    ///< inputs w, which solve M w = dg/dv for the `zero` of an event
};

/// Derivatives of variables along the motion, by their numbers.
using EventMotion = std::map<std::size_t, Scaled>;

struct LoweredEvents {
    Graph graph;              ///< graph of the system with more nodes; or a graph of their own
    std::size_t degrees = 0;  ///< number of coordinates
    std::vector<EventVariable> variables;  ///< inputs of the graph
    std::optional<Node> time;              ///< the input t, where there is one
    std::optional<LoweredVelocities> velocities = {};
    /// None where events have no slope. Where sums stay loops it may lack variables.
    EventMotion motion = {};
    std::vector<LoweredEvent> events;

    /// Returns whether the motion of all variables is known.
    [[nodiscard]] bool moves_all() const { return motion.size() == 2 * degrees; }
};

/// Throws InputError at `place` where a value of an event of an L depends on velocities.
void check_event_of_L(const Graph& graph, const Scaled& value, const Place& place);
/// Throws InputError at `place`, as an event of an L sets something.
[[noreturn]] void refuse_set_of_L(const Place& place);

/// Returns the events of a scene. Throws InputError for an event of an L that jumps, or that
/// depends on velocities where L calls functions of the user's own, and as lower(). Preconditions:
/// the scene is that of the system, also where its time is scaled, and the system is written out.
[[nodiscard]] LoweredEvents lowered_events(const System& system, const WrittenOutScene& scene);

}  // namespace hvi::gen
