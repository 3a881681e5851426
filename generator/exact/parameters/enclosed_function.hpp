// Power series of entire functions, by enclosures.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "generator/exact/parameters/ball_series.hpp"
#include "generator/exact/parameters/entire.hpp"

namespace hvi::gen {

[[nodiscard]] Ball absolute(Ball ball);

/// A function with its constants enclosed once.
class EnclosedFunction {
public:
    /// `majorant`: every term of every series is made positive.
    EnclosedFunction(const EntireFunction& function, const EntireGenerators& generators,
                     Precision bits, bool majorant = false);

    /// Returns the power series at `point`, which is not negative for a majorant.
    [[nodiscard]] BallSeries at(const Ball& point, std::size_t length) const;

private:
    using Powers = std::vector<std::vector<BallSeries>>;

    [[nodiscard]] Ball part(const Ball& ball) const { return majorant_ ? absolute(ball) : ball; }
    [[nodiscard]] BallSeries line(const Ball& scale, const Ball& point) const;
    [[nodiscard]] std::vector<BallSeries> variables_at(const Ball& point, slong count) const;
    [[nodiscard]] Powers powers_at(const Ball& point, slong count) const;

    Precision bits_;
    bool majorant_;
    std::vector<std::pair<Phase::Kind, Ball>> phases_;
    std::map<std::vector<unsigned>, Ball> terms_;  ///< coefficients of powers of w, x and y
    std::vector<unsigned> most_;                   ///< largest power of each variable
};

}  // namespace hvi::gen
