// How fast something goes, and how long it will take.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace hvi::gen {

/// The pace of what tells now and then which part of it is done.
class Pace {
public:
    using Clock = std::chrono::steady_clock;

    /// `all` of what is counted: 1e6, "steps".
    Pace(double all, std::string_view what) : all_(all), what_(what) {}

    /// `2.5e+06 steps/s, 12 s left` at a part from 0 to 1, from the first one on that was told;
    /// empty at that. Precondition: parts and times do not decrease.
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
