// Checks that indices stay within the ranges of their families.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Throws InputError at `place`, with the values of the indices of the loops, where an element of
/// the family has an index that leaves its range, for these sizes.
void check_ranges(const SystemFamily& family, const std::vector<ElementIndex>& indices,
                  const std::vector<Loop>& loops, const std::map<std::string, long>& sizes,
                  const Place& place);

}  // namespace hvi::gen
