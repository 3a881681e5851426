// The rows of a study: their steppers, and the workers of this machine that compute them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/cli/runner.hpp"
#include "generator/drive/ensemble_row.hpp"
#include "generator/ensembles/row_plan.hpp"
#include "generator/ensembles/row_source.hpp"
#include "generator/ensembles/study.hpp"

namespace hvi::gen {

/// Directions that rows carry along.
struct CarriedDirections {
    SceneStepper stepper;
    RowPlan plan;
};

/// All that rows of an ensemble have in common.
struct EnsembleWork {
    Scene scene;
    SceneStepper stepper;
    RowPlan plan;
    RowWishes wishes = {};
    std::optional<CarriedDirections> directions = {};

    /// Returns the names of the events that are counted.
    [[nodiscard]] std::vector<std::string> events() const;
    /// Whether the energy is among the conserved quantities.
    [[nodiscard]] bool has_energy() const;
};

/// Computes the chunks of a study by so many processes, which share the work with all other workers
/// of its directory. Shows progress. Returns false where an interruption has come. Throws
/// EnvironmentError where a worker fails. Precondition: begin(study), and interruptions are held.
bool compute(const Study& study, const EnsembleWork& work, const RowSource& source,
             std::size_t workers, Runner& runner);

}  // namespace hvi::gen
