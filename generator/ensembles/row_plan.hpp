// The parameters, start and steps of each row of an ensemble.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "generator/drive/ensemble_row.hpp"
#include "generator/module/start_parameters.hpp"
#include "generator/pipeline/stepper.hpp"
#include "generator/read/scene.hpp"
#include "generator/scene/step_count.hpp"

namespace hvi::gen {

/// A name whose value differs from row to row.
struct VariedName {
    std::string name;
    Place place;
};

/// The data of a row that follow from its values.
struct RowData {
    std::vector<double> numbers;  ///< of its stepper: see DrivenSystem
    double h = 0;
    std::int64_t steps = 0;
    std::optional<ScaledClock> clock = {};
    std::shared_ptr<const std::vector<DrivenEvent>> events = {};
    RowStatus fault = RowStatus::ok;  ///< unless it is ok the row has no steps
};

/// Finds the data of rows. A value is taken as the shortest decimal that is this double. What the
/// scene computes of it is computed exactly, so that a row has the bits of `run --param` with that
/// decimal.
class RowPlan {
public:
    /// `step` and `until` are those of the scene or of the command line. Names are those of
    /// parameters, of variables, which begin there, and `step` and `until`. Throws InputError, with
    /// its place, for a name that is none of these, for one that a program cannot change, and for
    /// one that comes twice.
    RowPlan(Scene scene, const SceneStepper& stepper, std::vector<VariedName> names,
            const NamedExpression& step, const NamedExpression& until);

    /// Returns the data of a row with these values, one for each name.
    [[nodiscard]] RowData at(std::span<const double> values) const;

    /// Returns the names of the values as columns: that of a variable with `_0` behind it.
    [[nodiscard]] std::vector<std::string> columns() const;

private:
    enum class Kind { number, start, step, until };
    /// The use of a value: for Kind::number and Kind::start its place among the numbers.
    struct Use {
        Kind kind;
        std::size_t number = 0;
    };
    struct Times {
        SceneTimes all;
        NamedExpression step, until;
    };

    [[nodiscard]] Use use_of(const VariedName& name) const;
    [[nodiscard]] std::vector<std::string> possible_names() const;
    void find_differences();
    [[nodiscard]] bool is_given(const StartValue& start) const;
    [[nodiscard]] bool differs(const Expression& expression) const;

    [[nodiscard]] Scene scene_of(std::span<const double> values) const;
    [[nodiscard]] Times times_of_row(const Scene& scene, std::span<const double> values) const;
    void compute_numbers(const Times& times, RowData& row) const;
    void compute_steps(const Times& times, RowData& row) const;
    void compute_events(const Scene& scene, RowData& row) const;

    Scene scene_;
    System system_;
    std::vector<StartValue> starts_;
    std::vector<VariedName> names_;
    std::vector<Use> uses_;
    NamedExpression step_, until_;
    std::set<std::string> different_;      ///< parameters that differ from row to row
    std::vector<bool> is_start_computed_;  ///< for each row, as it depends on what differs
    bool are_numbers_computed_ = false, are_steps_computed_ = false, are_events_computed_ = false;
    RowData usual_;  ///< data of a row without values
};

}  // namespace hvi::gen
