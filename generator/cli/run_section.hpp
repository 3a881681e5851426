// The picture of the events of a run.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/draw/section.hpp"
#include "generator/drive/trajectory.hpp"
#include "generator/read/written_out_scene.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// Axes of a picture of events: columns of the table of events.
struct SectionAxes {
    TableColumn x, y;
};

/// Returns the axes: the first coordinate that is no event's `zero`, and its momentum; the time and
/// the momentum where there is no other coordinate. Returns nothing without events.
[[nodiscard]] std::optional<SectionAxes> section_axes(const WrittenOutScene& scene,
                                                      const RunSubject& subject);

/// Returns the picture of the events that a run has met, without its table.
[[nodiscard]] SectionPicture section_of(std::string title, const SectionAxes& axes,
                                        const EventWishes& wishes, const Simulation& run);

}  // namespace hvi::gen
