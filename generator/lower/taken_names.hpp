// Names in a system, for passes that need others.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The names of sizes, parameters, families and invariants, and of the indices of all sums.
[[nodiscard]] std::set<std::string> taken_names(const System& system);

/// A name that is not taken, and is from now on: this one, with `_` behind it where it has to be.
[[nodiscard]] std::string new_name(std::string name, std::set<std::string>& taken);

}  // namespace hvi::gen
