// What the program asks of the operating system before it does anything else.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// An interruption ends the program with status 130, writing to a closed pipe is an error like any
/// other, and the numbers of closed standard streams are not given to files that are opened later.
void set_up_process();

}  // namespace hvi::gen
