// Slopes that an iteration begins with, from those of the last steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/interpret/tables.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// The tables N and N_before of a step, and what it remembers of the step before the last.
class StartingSlopes {
public:
    explicit StartingSlopes(const Iteration& iteration);

    /// Whether a step that goes on from another begins with slopes of that; else it begins with
    /// those at its start, and remember() is called.
    [[nodiscard]] bool are_known(bool goes_on) const {
        return exist_ && goes_on && (!takes_two_ || goes_on_);
    }

    /// Slopes of one kind, as they are before a step.
    struct Before {
        DoubleMatrix slopes;
    };

    /// Sets those with these indices from all slopes of the last step. Precondition: they are
    /// known.
    void extrapolate(DoubleMatrix& slopes, Before& before,
                     const std::vector<std::size_t>& unknown) const;

    /// Keeps what the step after this one takes.
    void remember(bool goes_on) { goes_on_ = goes_on; }
    void remember(const DoubleMatrix& slopes, Before& before) const {
        if (takes_two_) before.slopes = slopes;
    }

private:
    bool exist_, takes_two_ = false;
    DoubleMatrix last_, before_;
    bool goes_on_ = false;  ///< the last step went on from the one before it
};

}  // namespace hvi::gen
