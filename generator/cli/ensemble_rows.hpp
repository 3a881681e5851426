// Rows of a study, computed one after the other, or many at once.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/drive/ensemble_row.hpp"
#include "generator/drive/row_batch.hpp"
#include "generator/ensembles/row_plan.hpp"
#include "generator/ensembles/row_source.hpp"
#include "generator/ensembles/study.hpp"
#include "generator/simulate/answers.hpp"

namespace hvi::gen {

/// A stepper, and the numbers that rows have for it.
struct PlannedStepper {
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
    std::optional<PlannedStepper> directions = {};  ///< that rows alone carry along
    /// Steppers of many rows at once. A row whose iterations do not converge there is taken alone.
    std::optional<PlannedStepper> at_once = {};

    [[nodiscard]] bool are_on_device() const {
        return at_once && at_once->stepper.step.layout == Layout::threads;
    }
    /// Returns the names of the events that are counted.
    [[nodiscard]] std::vector<std::string> events() const;
    /// Whether the energy is among the conserved quantities.
    [[nodiscard]] bool has_energy() const;
};

/// The steppers of a study.
struct Families {
    StepperFamily steppers;
    StepperFamily directions = nullptr;
    const detail::RowFunctions* at_once = nullptr;
    std::string directory = {};  ///< of the files of the scene
};

/// Targets that take the steps of a study.
struct Targets {
    Target steppers;
    std::optional<Target> directions = {};
    std::optional<Library> at_once = {};

    /// Compiles solvers that steps seldom call. Returns whether some were missing. Throws as their
    /// build does.
    bool compile_solvers() const;

    /// Loads the steppers. Throws as steppers_of() does.
    [[nodiscard]] Families families() const;
};

/// Computes rows. Precondition: work and source live longer.
class StudyRows {
public:
    StudyRows(const EnsembleWork& work, RowSource& source, Families families)
        : work_(work), source_(source), families_(std::move(families)) {}

    /// Returns some of `count` rows, from the first on: of each its numbers, one for each column of
    /// the study. There is one at least, unless SIGTERM has come. Throws as take_row(),
    /// take_batch() and RowSource do.
    [[nodiscard]] std::vector<std::vector<double>> from(std::int64_t first, std::int64_t count);

private:
    /// A row before it begins, with its data for the steppers of many.
    struct Asked {
        std::vector<double> values;
        RowData data;
    };
    using Ends = std::vector<std::optional<RowEnd>>;

    [[nodiscard]] std::vector<Asked> asked(std::int64_t first, std::int64_t count);
    [[nodiscard]] std::optional<RowEnd> end_alone(const std::vector<double>& values) const;
    [[nodiscard]] Ends ends_at_once(const std::vector<Asked>& rows) const;
    [[nodiscard]] RowEnd none(RowStatus fault) const;
    void add(const RowEnd& end, std::vector<double>& row) const;

    const EnsembleWork& work_;
    RowSource& source_;
    Families families_;
};

}  // namespace hvi::gen
