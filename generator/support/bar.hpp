// A bar that grows, for those who wait at a terminal.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen {

/// One line of standard error, which goes away at the end of its life; nothing where that is no
/// terminal.
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
