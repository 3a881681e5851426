// Summands in the graph of a system, with their elements as inputs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

#include "generator/ir/system.hpp"
#include "generator/lower/declarations.hpp"
#include "generator/lower/loop_terms.hpp"

namespace hvi::gen {

/// Returns the value of a summand; its elements become accesses of the system. `known` are the
/// values of symbols, except indices of loops. Throws InputError, with its place in `source`, for a
/// word without a meaning and for an index that leaves its range, and NoLoops for an index of
/// another form than ElementIndex.
[[nodiscard]] Scaled value_of_term(System& system, const Declarations& names, const LoopTerm& term,
                                   const std::shared_ptr<const Source>& source, Symbols known);

}  // namespace hvi::gen
