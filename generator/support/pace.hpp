// The pace of a computation, and the time that it will take.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace hvi::gen {

/// The pace of a computation that reports its finished part now and then.
class Pace {
public:
    using Clock = std::chrono::steady_clock;

    /// `all` is the total with its unit: 1e6, "steps".
    Pace(double all, std::string_view what) : all_(all), what_(what) {}

    /// Returns `2.5e+06 steps/s, 12 s left` at a part from 0 to 1; empty at the first report.
    /// Precondition: parts and times do not decrease.
    [[nodiscard]] std::string at(double part, Clock::time_point now);

private:
    struct Told {
        double part;
        Clock::time_point time;
    };

    double all_;
    std::string_view what_;
    std::optional<Told> first_;
};

}  // namespace hvi::gen
