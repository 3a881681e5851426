// Events of a scene in the graph of its system.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/expr/event_direction.hpp"
#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// A new value of a variable.
struct LoweredJump {
    std::size_t variable;  ///< its number among coordinates, then conjugates
    Scaled value;
};

struct LoweredEvent {
    std::string name;
    EventDirection direction = EventDirection::both;
    long stop = 0;
    Scaled zero;
    /// The derivative along the motion, {zero, H} and that by the time; none of rotations, of L and
    /// where functions of the user's own are called.
    std::optional<Scaled> slope = {};
    std::vector<LoweredJump> set = {};
    Scaled cooldown = {}, period = {};  ///< of parameters; zero for none
};

struct LoweredEvents {
    Graph graph;               ///< that of the system, and more
    std::optional<Node> time;  ///< the input t, where there is one
    std::vector<LoweredEvent> events;
};

/// Throws InputError for an event of an L that depends on velocities or jumps, and as lower().
/// Preconditions: the scene is that of the system, also where its time is scaled, and the system is
/// written out.
[[nodiscard]] LoweredEvents lowered_events(const System& system, const WrittenOutScene& scene);

}  // namespace hvi::gen
