// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/ensemble_rows.hpp"

#include <limits>

#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

std::vector<std::string> EnsembleWork::events() const {
    std::vector<std::string> names;
    for (const IndexedEvent& event : scene.events) names.push_back(event.name);
    return names;
}

bool EnsembleWork::has_energy() const {
    const std::vector<std::string> names = conserved_names(stepper.system);
    return !names.empty() && names.front() == "energy";
}

bool Targets::compile_solvers() const {
    bool some_were_missing = false;
    for (const Target* target : {&steppers, directions ? &*directions : nullptr}) {
        const auto* library = target == nullptr ? nullptr : std::get_if<Library>(target);
        if (library == nullptr || !library->solvers || library->solvers->file()) continue;
        library->solvers->compile();
        some_were_missing = true;
    }
    return some_were_missing;
}

std::optional<std::vector<double>> StudyRows::at(std::int64_t number) {
    const std::vector<double> values = source_.at(number);
    const std::optional<RowEnd> end = end_of(values);
    if (!end) return {};
    std::vector<double> row{static_cast<double>(number)};
    row.insert(row.end(), values.begin(), values.end());
    add(*end, row);
    return row;
}

/// Returns the end of a row; that of one which takes no steps has no numbers.
std::optional<RowEnd> StudyRows::end_of(const std::vector<double>& values) const {
    const RowData data = work_.plan.at(values);
    if (data.fault != RowStatus::ok) return none(data.fault);
    RowStart start{.make = families_.steppers(data.numbers),
                   .h = data.h,
                   .steps = data.steps,
                   .clock = data.clock,
                   .events = data.events};
    if (work_.directions)
        start.make_directions = families_.directions(work_.directions->plan.at(values).numbers);
    return take_row(work_.wishes, start);
}

RowEnd StudyRows::none(RowStatus fault) const {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    return {.status = static_cast<std::size_t>(fault),
            .t = 0,
            .columns = std::vector<double>(work_.wishes.columns.size(), nothing),
            .energy_error = nothing,
            .events = std::vector<std::int64_t>(work_.scene.events.size()),
            .reduced = std::vector<double>(work_.wishes.reductions.size(), nothing),
            .lyapunov = nothing,
            .megno = nothing};
}

/// Adds what there is of an end, in the order of the columns of a study.
void StudyRows::add(const RowEnd& end, std::vector<double>& row) const {
    const auto asked = end.columns.begin() + static_cast<std::ptrdiff_t>(work_.count_of_state);
    row.insert(row.end(), end.columns.begin(), asked);
    row.insert(row.end(), {end.t, static_cast<double>(end.status), static_cast<double>(end.steps)});
    if (work_.has_energy()) row.push_back(end.energy_error);
    for (std::size_t k = 0; k < work_.scene.events.size(); ++k)
        row.push_back(static_cast<double>(end.events[k]));
    row.insert(row.end(), asked, end.columns.end());
    row.insert(row.end(), end.reduced.begin(), end.reduced.end());
    if (work_.wishes.growth) row.insert(row.end(), {end.lyapunov, end.megno});
}

}  // namespace hvi::gen
