// Events of a scene whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/lower/lowered_events.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// The events of the scene in a graph of their own, without slopes: their sums are written out,
/// elements are numbers of the state, and parameters have their values. Throws InputError for a
/// word without a meaning, for an element that there is none of, for sums of too many words, for
/// bodies that are set, and for an event of an L that depends on velocities or jumps.
[[nodiscard]] LoweredEvents lowered_events(const Scene& scene);

}  // namespace hvi::gen
