// Notes on a run in its table.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "generator/drive/row_file.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// Returns notes from which the run can be repeated: the scene and its text, the method, the size
/// of a step, and a command for the stepper with the given parameters. They contain no date or
/// time.
[[nodiscard]] std::vector<TableNote> notes_on(const Scene& scene, const SceneStepper& stepper,
                                              const RunSubject& subject, double step);

/// Returns the kinds of the columns, by their names without an index.
[[nodiscard]] std::map<std::string, std::string, std::less<>>
meanings_of(const RunSubject& subject);

}  // namespace hvi::gen
