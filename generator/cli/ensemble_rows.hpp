// Rows of a study, computed one after the other.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/drive/ensemble_row.hpp"
#include "generator/ensembles/row_plan.hpp"
#include "generator/ensembles/row_source.hpp"
#include "generator/ensembles/study.hpp"
#include "generator/simulate/answers.hpp"

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
    RowWishes wishes = {};           ///< its columns are the state, then those that are asked for
    std::size_t count_of_state = 0;  ///< columns of the state
    std::optional<CarriedDirections> directions = {};

    /// Returns the names of the events that are counted.
    [[nodiscard]] std::vector<std::string> events() const;
    /// Whether the energy is among the conserved quantities.
    [[nodiscard]] bool has_energy() const;
};

/// The steppers of a study.
struct Families {
    StepperFamily steppers;
    StepperFamily directions = nullptr;
};

/// Targets that take the steps of a study.
struct Targets {
    Target steppers;
    std::optional<Target> directions = {};

    /// Compiles solvers that steps seldom call. Returns whether some were missing. Throws as their
    /// build does.
    bool compile_solvers() const;

    /// Loads the steppers. Throws as steppers_of() does.
    [[nodiscard]] Families families() const {
        return {steppers_of(steppers), directions ? steppers_of(*directions) : StepperFamily()};
    }
};

/// Computes rows. Precondition: work and source live longer.
class StudyRows {
public:
    StudyRows(const EnsembleWork& work, RowSource& source, Families families)
        : work_(work), source_(source), families_(std::move(families)) {}

    /// Returns the numbers of a row, one for each column of the study; nothing where SIGTERM has
    /// come. Throws as take_row() and RowSource do.
    [[nodiscard]] std::optional<std::vector<double>> at(std::int64_t number);

private:
    [[nodiscard]] std::optional<RowEnd> end_of(const std::vector<double>& values) const;
    [[nodiscard]] RowEnd none(RowStatus fault) const;
    void add(const RowEnd& end, std::vector<double>& row) const;

    const EnsembleWork& work_;
    RowSource& source_;
    Families families_;
};

}  // namespace hvi::gen
