// Conditions for all elements that a system with loops reads to exist, for sizes that a program
// sets.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>

#include "generator/emit/system/class_names.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns conditions of C++ on the members of System that hold for the sizes of the scene: `N_ <=
/// static_cast<Place>(m_values_.size())`, ... Conditions that hold for all sizes are left out, and
/// so are those that the bounds of each loop alone do not show: element_ranges has checked these
/// for the scene's sizes.
[[nodiscard]] std::set<std::string> conditions_of_sums(const System& system,
                                                       const ClassNames& names);

/// Returns the conditions on elements that initial values are made of.
[[nodiscard]] std::set<std::string> conditions_of_starts(const System& system,
                                                         const ClassNames& names);

}  // namespace hvi::gen
