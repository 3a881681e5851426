// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace hvi::gen {

namespace {

constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

Bar::Bar() : is_terminal_(::isatty(STDERR_FILENO) != 0) {}

Bar::~Bar() {
    if (is_shown_) std::fputs(clear_line, stderr);
}

void Bar::show(double part, std::string_view what) {
    if (!is_terminal_) return;
    constexpr int width = 30;
    const int full = static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * width));
    std::string line = clear_line;
    line += '[' + std::string(static_cast<std::size_t>(full), '#') +
            std::string(static_cast<std::size_t>(width - full), ' ') + "] ";
    line += std::to_string(std::lround(100 * part)) + " % ";
    line += what;
    std::fputs(line.c_str(), stderr);
    is_shown_ = true;
}

}  // namespace hvi::gen
