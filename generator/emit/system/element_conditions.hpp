// When all elements that a system with loops looks at are there: for sizes of a program's own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>

#include "generator/emit/system/class_names.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// `N_ <= static_cast<Place>(m_values_.size())`, ...: conditions of C++ on the members of System
/// that hold for the sizes of the scene. What holds for all sizes is left out, and so is what
/// bounds of each loop alone do not show: element_ranges has looked at these for the scene's sizes.
[[nodiscard]] std::set<std::string> conditions_of_sums(const System& system,
                                                       const ClassNames& names);

/// The same of what initial values are made of.
[[nodiscard]] std::set<std::string> conditions_of_starts(const System& system,
                                                         const ClassNames& names);

}  // namespace hvi::gen
