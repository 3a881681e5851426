// Events of a scene whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/lower/lowered_events.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Returns the events of the scene in a graph of their own: their sums are written out, elements
/// are numbers of the state, and parameters have their values. Events have slopes where H or L has
/// at most 100 000 words with its sums written out, in unscaled time and without functions of the
/// user's own; the motion is that of all variables where an event ends the run, and there are at
/// most most_degrees_of_freedom. Throws InputError for a word without a meaning, for an element
/// that does not exist, for sums of too many words, for bodies that are set, and for an event of an
/// L that jumps, or depends on velocities where it has no slope.
[[nodiscard]] LoweredEvents lowered_events(const Scene& scene);

}  // namespace hvi::gen
