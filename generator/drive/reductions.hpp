// Reductions: numbers of a run that depend on each of its steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <hvi/detail/numbers/compensated.hpp>

#include "generator/read/reductions.hpp"

namespace hvi::gen {

/// The least value, the largest, and the mean over time by the trapezoidal rule. For steps of one
/// size that is the mean of all values, in which the first and the last count half. A value that is
/// no number makes the result none.
class Reductions {
public:
    using Value = std::function<double(std::size_t column)>;

    explicit Reductions(const std::vector<Reduction>& wishes)
        : wishes_(wishes), states_(wishes.size()) {}

    [[nodiscard]] bool any() const { return !wishes_.empty(); }
    /// Whether there are reductions of columns from this number on.
    [[nodiscard]] bool any_from(std::size_t column) const;

    void begin(double t, const Value& value);
    /// Takes values after a step, or at the end of the run within a step.
    void see(double t, const Value& value);

    [[nodiscard]] std::vector<double> results() const;

    /// Returns the data from which reductions resume, as numbers.
    [[nodiscard]] std::vector<double> memory() const;
    [[nodiscard]] std::size_t memory_size() const { return 2 + 3 * states_.size(); }
    /// Resumes. Precondition: the memory has memory_size() numbers.
    void resume(const std::vector<double>& memory);

private:
    struct State {
        Sum<double> total{0, 0};  ///< or the least or largest value so far
        double last = 0;          ///< value
    };

    const std::vector<Reduction>& wishes_;
    std::vector<State> states_;
    double first_ = 0, last_ = 0;  ///< times
};

}  // namespace hvi::gen
