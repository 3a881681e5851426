// The present machine, as far as run times depend on it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace hvi::gen {

struct Machine {
    std::string processor;   ///< its model's name; empty where the system does not tell
    std::string extensions;  ///< its special features, which distinguish machines
    int threads = 0;         ///< threads at once
    std::string system;      ///< kernel and architecture: `Linux 6.1.0 x86_64`
};

[[nodiscard]] Machine this_machine();

}  // namespace hvi::gen
