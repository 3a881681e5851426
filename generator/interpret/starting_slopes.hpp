// Slopes that an iteration begins with, extrapolated from the last steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/interpret/tables.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Tables N and N_before of a step, and its memory of the step before the last.
class StartingSlopes {
public:
    explicit StartingSlopes(const Iteration& iteration);

    /// Returns whether a step has slopes of earlier steps to begin with. Otherwise it begins with
    /// the slopes at its start, and remember() is called.
    [[nodiscard]] bool are_known(bool goes_on) const {
        return exist_ && goes_on && (!takes_two_ || goes_on_);
    }

    /// Slopes of one kind before the last step.
    struct Before {
        DoubleMatrix slopes;
    };

    /// Sets the slopes with these indices from all slopes of the last step. Precondition: they are
    /// known.
    void extrapolate(DoubleMatrix& slopes, Before& before,
                     const std::vector<std::size_t>& unknown) const;

    /// Keeps the slopes for the next step.
    void remember(bool goes_on) { goes_on_ = goes_on; }
    void remember(const DoubleMatrix& slopes, Before& before) const {
        if (takes_two_) before.slopes = slopes;
    }

private:
    bool exist_, takes_two_ = false;
    DoubleMatrix last_, before_;
    bool goes_on_ = false;  ///< whether the last step went on from the one before it
};

}  // namespace hvi::gen
