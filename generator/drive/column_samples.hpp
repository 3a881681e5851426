// Columns of a run at equal distances of time, and their frequencies.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "generator/drive/rows.hpp"
#include "generator/drive/trajectory.hpp"

namespace hvi::gen {

/// Samples of columns, at steps or at the times of rows. If there are more than 2^18 for a column
/// or 2^24 in all, only each second one is taken, or each third one, and so on.
class ColumnSamples {
public:
    explicit ColumnSamples(const TrajectoryWishes& wishes);

    /// Returns the number of steps to the next sample at steps.
    [[nodiscard]] std::int64_t ahead(std::int64_t taken) const { return every_ - taken % every_; }

    /// Takes a sample after `taken` steps, if there is one.
    void see(std::int64_t taken, const Rows::Value& value) {
        if (!has_times_ && taken % every_ == 0) add(value);
    }

    /// Takes a sample at the next of the times, if there is one.
    void see_row(const Rows::Value& value) {
        if (rows_++ % every_ == 0) add(value);
    }

    /// Reports the terms of each column: none where there are too few samples, or not all are
    /// finite.
    void tell() const;

private:
    void add(const Rows::Value& value);
    void tell(const std::vector<double>& values) const;

    std::vector<std::size_t> numbers_;  ///< numbers of the columns
    bool has_times_;
    std::int64_t every_ = 1, rows_ = 0;
    double first_ = 0, step_ = 0;
    std::vector<std::vector<double>> columns_;
};

}  // namespace hvi::gen
