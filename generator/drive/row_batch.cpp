// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/row_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/drive/checkpoint_saver.hpp"
#include "generator/drive/rows_module.hpp"
#include "generator/drive/tangents.hpp"

namespace hvi::gen {

namespace {

/// The ends of all rows, as a module writes them.
class BatchEnds {
public:
    BatchEnds(const detail::DrivenSizes& sizes, std::size_t count)
        : variables_(sizes.coordinates + sizes.momenta),
          state_(variables_ + (sizes.has_time ? 1 : 0)),
          conserved_(sizes.invariants + (sizes.has_time ? 0 : 1)),
          states(count * state_),
          conserved(count * conserved_),
          energy_errors(count),
          growths(2 * count),
          taken(count),
          statuses(count) {}

    [[nodiscard]] std::optional<RowEnd> of(std::size_t row, const RowWishes& wishes,
                                           double h) const {
        if (statuses[row] == detail::row_not_finished) return {};
        RowEnd end{.status = status(row),
                   .steps = taken[row],
                   .t = static_cast<double>(taken[row]) * h,
                   .energy_error = energy_errors[row]};
        for (const std::size_t number : wishes.columns)
            end.columns.push_back(value(row, number, wishes.growth));
        if (wishes.growth) add_growth(row, h, end);
        return end;
    }

private:
    /// Returns the number of a code; a start that is no number is called so.
    [[nodiscard]] std::size_t status(std::size_t row) const {
        const double* const first = states.data() + row * state_;
        const auto is_number = [](double value) { return std::isfinite(value); };
        const bool has_failed = statuses[row] != 0;
        if (has_failed && taken[row] == 0 && !std::all_of(first, first + variables_, is_number))
            return static_cast<std::size_t>(RowStatus::no_number);
        return static_cast<std::size_t>(statuses[row]);
    }

    /// Returns a value by its column number. NOTE: with a direction, q is the first half of the
    /// coordinates, and p the second one of the momenta.
    [[nodiscard]] double value(std::size_t row, std::size_t number, bool has_direction) const {
        const std::size_t columns = has_direction ? variables_ / 2 : variables_;
        if (number >= columns) return conserved[row * conserved_ + number - columns];
        const bool is_momentum = has_direction && number >= columns / 2;
        return states[row * state_ + number + (is_momentum ? columns : 0)];
    }

    void add_growth(std::size_t row, double h, RowEnd& end) const {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        const bool is_there = end.status == 0 && end.steps > 0;
        const double time = std::abs(h * static_cast<double>(end.steps));
        end.lyapunov = is_there ? growths[2 * row] / time : none;
        end.megno = is_there ? growths[2 * row + 1] : none;
    }

    std::size_t variables_, state_, conserved_;

public:
    std::vector<double> states, conserved, energy_errors, growths;
    std::vector<std::int64_t> taken;
    std::vector<int> statuses;
};

}  // namespace

void RowBatch::add(const std::vector<double>& of_row, double size, std::int64_t count) {
    numbers.insert(numbers.end(), of_row.begin(), of_row.end());
    h.push_back(size);
    steps.push_back(count);
}

std::vector<std::optional<RowEnd>> take_batch(const RowWishes& wishes,
                                              const detail::RowFunctions& call,
                                              const std::string& directory, const RowBatch& batch) {
    const std::size_t count = batch.size();
    BatchEnds ends(call.sizes, count);
    const std::size_t variables = call.sizes.coordinates + call.sizes.momenta;
    const bool looks = std::any_of(wishes.columns.begin(), wishes.columns.end(),
                                   [&](std::size_t number) { return number >= variables; });
    const std::vector<double> direction =
        wishes.growth ? growing_direction(variables / 2) : std::vector<double>();
    const detail::EnsembleRows rows{.count = count,
                                    .parameters = batch.numbers.data(),
                                    .h = batch.h.data(),
                                    .steps = batch.steps.data(),
                                    .states = ends.states.data(),
                                    .taken = ends.taken.data(),
                                    .statuses = ends.statuses.data(),
                                    .energy_errors = ends.energy_errors.data(),
                                    .conserved = looks ? ends.conserved.data() : nullptr,
                                    .is_stopped = is_stopped,
                                    .direction = wishes.growth ? direction.data() : nullptr,
                                    .growths = wishes.growth ? ends.growths.data() : nullptr};
    if (count > 0) take_rows(call, directory, batch.numbers.size() / count, rows);
    std::vector<std::optional<RowEnd>> result;
    for (std::size_t row = 0; row < count; ++row)
        result.push_back(ends.of(row, wishes, batch.h[row]));
    return result;
}

}  // namespace hvi::gen
