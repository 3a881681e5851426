// Names in a system, for passes that need new ones.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the names of sizes, parameters, families and invariants, and of the indices of all sums.
[[nodiscard]] std::set<std::string> taken_names(const System& system);

/// Returns a name that is not taken, and takes it: `name`, followed by `_` where needed.
[[nodiscard]] std::string new_name(std::string name, std::set<std::string>& taken);

}  // namespace hvi::gen
