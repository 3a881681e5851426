// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/pace.hpp"

#include <cmath>
#include <cstdio>

namespace hvi::gen {

namespace {

/// Returns `12 s`, `3 min`, `2.5 h`.
std::string in_words(double seconds) {
    char text[64];
    if (seconds < 100)
        std::snprintf(text, sizeof text, "%.0f s", std::ceil(seconds));
    else if (seconds < 6000)
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    else
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
    return text;
}

}  // namespace

std::string Pace::at(double part, Clock::time_point now) {
    if (!first_) {
        first_ = {part, now};
        return {};
    }
    const double seconds = std::chrono::duration<double>(now - first_->time).count();
    const double done = part - first_->part;
    if (!(seconds > 0 && done > 0)) return {};
    char rate[64];
    std::snprintf(rate, sizeof rate, "%.3g ", done * all_ / seconds);
    return rate + std::string(what_) + "/s, " + in_words((1 - part) * seconds / done) + " left";
}

}  // namespace hvi::gen
