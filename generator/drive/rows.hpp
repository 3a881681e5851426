// Tables of a trajectory, written step by step.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "generator/drive/row_file.hpp"
#include "generator/drive/table.hpp"
#include "generator/drive/trajectory.hpp"

namespace hvi::gen {

/// Numbers of a run: at one step in `every` and at the end, or at given times.
class Rows {
public:
    using Value = std::function<double(std::size_t number)>;

    /// Makes a new table.
    explicit Rows(const TableWishes& wishes);

    /// The place of a resumed table: its bytes and rows, and the steps at the time t.
    struct Place {
        std::int64_t size, rows, steps;
        double t;
    };
    Rows(const TableWishes& wishes, const Place& from);

    [[nodiscard]] bool good() const { return table_->good(); }
    [[nodiscard]] std::int64_t count() const { return count_; }
    [[nodiscard]] bool has_times() const { return has_times_; }

    [[nodiscard]] bool has_row(std::int64_t taken) const { return taken % every_ == 0; }

    /// Returns the number of steps to the next row.
    [[nodiscard]] std::int64_t ahead(std::int64_t taken) const { return every_ - taken % every_; }

    /// Writes the row after `taken` steps, where there is one.
    void see(std::int64_t taken, double time, const Value& value) {
        if (!has_times_ && has_row(taken)) write(time, value);
    }

    /// Writes the last row, unless it is written already.
    void see_end(double time, const Value& value) {
        if (!has_times_ && last_ != time) write(time, value);
    }

    void write(double time, const Value& value);

    [[nodiscard]] std::int64_t flushed_size() { return table_->flushed_size(); }
    [[nodiscard]] bool close() { return table_->close(); }

private:
    std::int64_t every_;
    bool has_times_;
    std::vector<std::size_t> numbers_;  // numbers of the columns
    std::unique_ptr<RowFile> table_;
    std::vector<double> values_;  // values of a row
    std::int64_t count_ = 0;
    std::optional<double> last_;  // time of the last row
};

/// The table of the events of a run.
class EventRows {
public:
    explicit EventRows(const EventWishes& wishes);
    EventRows(const EventWishes& wishes, std::int64_t size);

    /// Writes the number-th event of a name.
    void write(const std::string& name, std::int64_t number, double time,
               const DrivenStepper::State& x);

    [[nodiscard]] std::int64_t flushed_size() { return table_ ? table_->flushed_size() : 0; }
    [[nodiscard]] bool close() { return !table_ || table_->close(); }

private:
    std::vector<std::size_t> numbers_;  ///< numbers of the variables
    std::optional<NumberTable> table_;
};

}  // namespace hvi::gen
