// Progress of steps that are taken one by one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#include <driver/answer.hpp>

namespace hvi::gen {

/// Reports progress ten times a second: from `begin` to `end`, which are parts of the whole work.
class ProgressOfSteps {
public:
    ProgressOfSteps(std::int64_t steps, double begin, double end)
        : steps_(steps), begin_(begin), end_(end) {}

    void tell(std::int64_t taken) {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        const double part = static_cast<double>(taken) / static_cast<double>(steps_);
        driver::say("progress", begin_ + (end_ - begin_) * part);
    }

private:
    std::int64_t steps_;
    double begin_, end_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace hvi::gen
