// Warnings on standard error, which do not end the program.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace hvi::gen {

/// Prints `warning: WHAT` and `help: WHAT WOULD HELP`, shown as errors are, unless they were
/// printed before. Several threads may call it.
void warn(const std::string& what, const std::string& help = {});

}  // namespace hvi::gen
