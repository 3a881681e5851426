// A progress bar for users who wait at a terminal.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen {

/// A bar in one line of standard error. Its destructor removes it. Shows nothing where standard
/// error is no terminal.
class Bar {
public:
    Bar();
    ~Bar();
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;

    /// `part` is from 0 to 1.
    void show(double part, std::string_view what = {});

private:
    bool is_terminal_;
    bool is_shown_ = false;
};

}  // namespace hvi::gen
