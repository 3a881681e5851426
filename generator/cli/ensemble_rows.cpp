// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/ensemble_rows.hpp"

#include <limits>

#include <hvi/state.hpp>

#include "generator/drive/rows_module.hpp"
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

Families Targets::families() const {
    Families result{steppers_of(steppers)};
    if (directions) result.directions = steppers_of(*directions);
    if (!at_once) return result;
    result.at_once = &loaded_rows(std::filesystem::absolute(at_once->file).string());
    result.directory = std::filesystem::absolute("." / at_once->directory).string();
    return result;
}

std::vector<std::vector<double>> StudyRows::from(std::int64_t first, std::int64_t count) {
    std::vector<std::vector<double>> rows;
    const auto add_row = [&](const std::vector<double>& values, const std::optional<RowEnd>& end) {
        if (!end) return false;
        rows.push_back({static_cast<double>(first + static_cast<std::int64_t>(rows.size()))});
        rows.back().insert(rows.back().end(), values.begin(), values.end());
        add(*end, rows.back());
        return true;
    };
    if (families_.at_once == nullptr) {
        const std::vector<double> values = source_.at(first);
        add_row(values, end_alone(values));
        return rows;
    }
    const std::vector<Asked> all = asked(first, count);
    const Ends ends = ends_at_once(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!add_row(all[i].values, ends[i])) break;
    return rows;
}

/// Returns rows that are taken together: as many as take a moment, so that progress is seen. A GPU
/// takes all.
std::vector<StudyRows::Asked> StudyRows::asked(std::int64_t first, std::int64_t count) {
    constexpr std::int64_t side_by_side = 4096, fewest = 32, most_steps = 4'000'000;
    const std::int64_t most = work_.are_on_device() ? count : side_by_side;
    std::vector<Asked> rows;
    std::int64_t steps = 0;
    const auto is_enough = [&] {
        const auto size = static_cast<std::int64_t>(rows.size());
        return size == most || (!work_.are_on_device() && size >= fewest && steps > most_steps);
    };
    for (std::int64_t number = first; number < first + count && !is_enough(); ++number) {
        std::vector<double> values = source_.at(number);
        RowData data = work_.at_once->plan.at(values);
        steps += std::min(data.steps, most_steps);
        rows.push_back({std::move(values), std::move(data)});
    }
    return rows;
}

/// Returns the ends of rows. NOTE: fixed points are iterated there. Alone, a row may go on with
/// Newton's method, so that one which is stiff has an end as well.
StudyRows::Ends StudyRows::ends_at_once(const std::vector<Asked>& rows) const {
    constexpr auto stiff = static_cast<std::size_t>(Status::Code::not_converged);
    RowBatch batch;
    for (const Asked& row : rows)
        if (row.data.fault == RowStatus::ok)
            batch.add(row.data.numbers, row.data.h, row.data.steps);
    Ends taken = take_batch(work_.wishes, *families_.at_once, families_.directory, batch);
    Ends ends;
    auto next = taken.begin();
    for (const Asked& row : rows) {
        const bool is_taken = row.data.fault == RowStatus::ok;
        ends.push_back(is_taken ? std::move(*next++) : none(row.data.fault));
        if (ends.back() && ends.back()->status == stiff) ends.back() = end_alone(row.values);
    }
    return ends;
}

std::optional<RowEnd> StudyRows::end_alone(const std::vector<double>& values) const {
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

/// Returns the end of a row that takes no steps, and has no numbers.
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
