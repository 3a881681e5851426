// A word on standard error about what does not end the program.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace hvi::gen {

/// Prints `warning: WHAT` and `help: WHAT WOULD HELP`, shown as errors are, the first time that it
/// is called with these words. Several threads may call it.
void warn(const std::string& what, const std::string& help = {});

}  // namespace hvi::gen
