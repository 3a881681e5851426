// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/row_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/graph/written.hpp"
#include "generator/hamiltonian/time_scale.hpp"
#include "generator/interpret/event_program.hpp"
#include "generator/module/driven.hpp"
#include "generator/module/stepper_part.hpp"
#include "generator/read/method.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Returns the shortest decimal that is this double, as an assignment.
std::shared_ptr<const Source> assignment(const std::string& name, double value) {
    return std::make_shared<const Source>(Source{"row", fmt::format("{}={}", name, value)});
}

std::shared_ptr<const Source> decimal(double value) {
    return std::make_shared<const Source>(Source{"row", fmt::format("{}", value)});
}

bool mentions(const Expression& expression, const std::set<std::string>& names) {
    bool found = false;
    walk(expression, [&](const Expression& part) {
        const bool is_name =
            part.kind == Expression::Kind::symbol || part.kind == Expression::Kind::element;
        found = found || (is_name && names.contains(part.name));
        return !found;
    });
    return found;
}

/// Whether a function of a scene's words may depend on parameters with these names. NOTE: names of
/// definitions stand for anything.
bool may_mention(const Scene& scene, const IndexedExpression& function,
                 const std::set<std::string>& names) {
    return !scene.definitions.empty() || mentions(function.written, names);
}

bool may_mention(const Scene& scene, const IndexedEvent& event,
                 const std::set<std::string>& names) {
    if (may_mention(scene, event.zero, names)) return true;
    for (const auto* span : {&event.cooldown, &event.period})
        if (*span && may_mention(scene, **span, names)) return true;
    if (!event.set) return false;
    return std::any_of(event.set->values.begin(), event.set->values.end(),
                       [&](const IndexedValue& value) {
                           const auto* written = std::get_if<IndexedExpression>(&value.value);
                           return written == nullptr || may_mention(scene, *written, names);
                       });
}

/// Whether a value may depend on parameters with these names. NOTE: a long one is not looked at.
bool may_depend(const Graph& graph, const Scaled& value, const std::set<std::string>& names) {
    const std::optional<Expression> expression = written(graph, value);
    return !expression || mentions(*expression, names);
}

/// Returns the number of sizes that stand before parameters in a module's numbers.
std::size_t sizes_before(const System& system) {
    return has_sizes(system) ? system.sizes.size() : 0;
}

}  // namespace

RowPlan::RowPlan(Scene scene, const SceneStepper& stepper, std::vector<VariedName> names,
                 const NamedExpression& step, const NamedExpression& until)
    : scene_(std::move(scene)),
      system_(stepper.system),
      names_(std::move(names)),
      step_(step),
      until_(until) {
    const DrivenSystem driven = driven_system(system_);
    const std::size_t given = values_of_numbers(system_).size();
    // NOTE: where a starting value cannot be computed none of them is a number.
    if (driven.system.parameters.size() > system_.parameters.size())
        starts_ = start_values(system_);
    usual_.numbers = driven.numbers;
    HVI_CHECK(driven.numbers.size() >= given + starts_.size());
    for (const VariedName& name : names_) uses_.push_back(use_of(name));
    find_differences();
    const Times times{times_of(scene_), step_, until_};
    if (!are_steps_computed_) compute_steps(times, usual_);
    if (!are_events_computed_) compute_events(scene_, usual_);
}

std::vector<std::string> RowPlan::columns() const {
    std::vector<std::string> result;
    for (std::size_t k = 0; k < names_.size(); ++k)
        result.push_back(names_[k].name + (uses_[k].kind == Kind::start ? "_0" : ""));
    return result;
}

// ---- names ----

std::vector<std::string> RowPlan::possible_names() const {
    std::vector<std::string> result;
    for (const SystemParameter& parameter : system_.parameters)
        if (!scene_.fixed.contains(parameter.name)) result.push_back(parameter.name);
    for (const StartValue& start : starts_)
        if (!start.variable.empty()) result.push_back(start.variable);
    result.insert(result.end(), {"step", "until"});
    return result;
}

RowPlan::Use RowPlan::use_of(const VariedName& name) const {
    const auto twice = std::count_if(names_.begin(), names_.end(), [&](const VariedName& other) {
        return other.name == name.name;
    });
    if (twice > 1)
        throw InputError(fmt::format("`{}` gets its values twice", name.name), name.place);
    if (scene_.fixed.contains(name.name))
        throw InputError(
            fmt::format("`{}` is a parameter of the method, too: it is one number for all rows",
                        name.name),
            name.place);
    const std::size_t first = sizes_before(system_);
    for (std::size_t k = 0; k < system_.parameters.size(); ++k)
        if (system_.parameters[k].name == name.name) return {Kind::number, first + k};
    const std::size_t first_start = first + system_.parameters.size();
    for (std::size_t k = 0; k < starts_.size(); ++k)
        if (starts_[k].variable == name.name) return {Kind::start, first_start + k};
    if (name.name == "step") return {Kind::step};
    if (name.name == "until") return {Kind::until};
    const std::vector<std::string> names = possible_names();
    const std::string all = "rows may differ in " + listed(names);
    throw InputError(fmt::format("no row can have its own `{}`", name.name), name.place,
                     did_you_mean(name.name, {names.begin(), names.end()},
                                  system_.is_written_out()
                                      ? all
                                      : all + "; with --unroll yes in starting values, too"));
}

// ---- differences between rows ----

bool RowPlan::differs(const Expression& expression) const {
    return mentions(expression, different_);
}

/// Whether rows have values of a start of their own.
bool RowPlan::is_given(const StartValue& start) const {
    return std::any_of(names_.begin(), names_.end(),
                       [&](const VariedName& name) { return name.name == start.variable; });
}

/// Finds what differs from row to row besides the values themselves.
void RowPlan::find_differences() {
    for (std::size_t k = 0; k < names_.size(); ++k) {
        if (uses_[k].kind == Kind::number) different_.insert(names_[k].name);
        const bool is_of_steps = uses_[k].kind == Kind::step || uses_[k].kind == Kind::until;
        are_steps_computed_ = are_steps_computed_ || is_of_steps;
    }
    if (different_.empty()) return;
    // NOTE: parameters depend on those before them.
    for (const IndexedValue& parameter : scene_.parameters) {
        const auto* written = std::get_if<IndexedExpression>(&parameter.value);
        if (written == nullptr || different_.contains(parameter.name)) continue;
        if (!differs(written->written)) continue;
        different_.insert(parameter.name);
        are_numbers_computed_ = true;
    }
    for (const StartValue& start : starts_) {
        const bool depends = !is_given(start) && may_depend(system_.graph, start.value, different_);
        is_start_computed_.push_back(depends);
        are_numbers_computed_ = are_numbers_computed_ || depends;
    }
    are_steps_computed_ =
        are_steps_computed_ || differs(step_.expression) || differs(until_.expression);
    are_events_computed_ =
        std::any_of(scene_.events.begin(), scene_.events.end(), [&](const IndexedEvent& event) {
            return may_mention(scene_, event, different_);
        });
}

// ---- a row ----

RowData RowPlan::at(std::span<const double> values) const {
    RowData row = usual_;
    const auto is_number = [](double value) { return std::isfinite(value); };
    if (!std::all_of(values.begin(), values.end(), is_number)) {
        row.fault = RowStatus::no_number;
        return row;
    }
    if (are_numbers_computed_ || are_steps_computed_ || are_events_computed_) {
        const Scene scene = scene_of(values);
        const Times times = times_of_row(scene, values);
        if (are_numbers_computed_) compute_numbers(times, row);
        if (are_steps_computed_) compute_steps(times, row);
        if (are_events_computed_) compute_events(scene, row);
    }
    for (std::size_t k = 0; k < values.size(); ++k)
        if (uses_[k].kind == Kind::number || uses_[k].kind == Kind::start)
            row.numbers[uses_[k].number] = values[k];
    return row;
}

Scene RowPlan::scene_of(std::span<const double> values) const {
    Scene scene = scene_;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (uses_[k].kind == Kind::number)
            static_cast<void>(
                assign(scene, parse_parameter(assignment(names_[k].name, values[k]))));
    return scene;
}

RowPlan::Times RowPlan::times_of_row(const Scene& scene, std::span<const double> values) const {
    Times times{times_of(scene), step_, until_};
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (uses_[k].kind == Kind::step)
            times.step = expression_of_parameters(times.all, "step", decimal(values[k]));
        if (uses_[k].kind == Kind::until)
            times.until = expression_of_parameters(times.all, "until", decimal(values[k]));
    }
    return times;
}

/// Computes parameters, and starting values that depend on what differs.
void RowPlan::compute_numbers(const Times& times, RowData& row) const {
    std::map<std::string, Expression> parameters;
    for (const Parameter& parameter : times.all.parameters)
        parameters.emplace(parameter.name, parameter.value);
    std::size_t place = sizes_before(system_);
    try {
        for (const SystemParameter& parameter : system_.parameters) {
            const auto found = parameters.find(parameter.name);
            if (found != parameters.end()) row.numbers[place] = value_of_number(found->second);
            ++place;
        }
        for (std::size_t k = 0; k < starts_.size(); ++k) {
            if (!is_start_computed_[k]) continue;
            const std::optional<double> number = starts_[k].number(system_.graph, parameters);
            if (!number) row.fault = RowStatus::no_number;
            row.numbers[place + k] = number.value_or(0);
        }
    } catch (const MathError&) { row.fault = RowStatus::no_number; }
}

void RowPlan::compute_steps(const Times& times, RowData& row) const {
    try {
        if (!scene_.scale) {
            const Steps steps = steps_until(times.all, times.step, times.until);
            row.h = steps.size;
            row.steps = steps.count;
            return;
        }
        constexpr std::int64_t most = 1'000'000'000'000'000;
        row.h = nearest_value(times.all, times.step);
        row.clock = ScaledClock{nearest_value(times.all, times.until)};
        row.steps = most;
        if (row.h == 0 || row.h * row.clock->until < 0) row.fault = RowStatus::no_steps;
    } catch (const MathError&) { row.fault = RowStatus::no_steps; }
}

void RowPlan::compute_events(const Scene& scene, RowData& row) const {
    if (scene.events.empty() && !scene.kinks) return;
    System system = system_;
    const SceneTimes times = times_of(scene);
    for (SystemParameter& parameter : system.parameters)
        for (const Parameter& value : times.parameters)
            if (value.name == parameter.name) parameter.value = value.value;
    row.events = std::make_shared<const std::vector<DrivenEvent>>(
        system.is_written_out() ? driven_events(system, with_time_scale(unrolled(scene)))
                                : driven_events(scene));
}

}  // namespace hvi::gen
