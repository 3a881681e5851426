// Sums taken apart into summands with the loops around them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

/// A summand, in which names have indices and no sum stands, and the loops around it.
struct LoopTerm {
    std::vector<Loop> loops;
    Expression term;
};

/// The term within one more loop, the innermost. The index gets another name where its own is
/// taken, or is that of a loop around it.
[[nodiscard]] LoopTerm within_loop(LoopTerm term, const std::string& index, LoopRange range,
                                   const std::set<std::string>& taken);

/// The expression with its sums written out. Throws InputError for one of more than 16 terms, or
/// with bounds that are no numbers.
[[nodiscard]] Expression without_sums(const IndexedExpression& expression);

/// What names mean where sums are taken apart.
struct TermNames {
    std::set<std::string> taken;  ///< that no index may have; it gets another then
    /// The variables among these: Role::coordinate, Role::conjugate, or 0.
    std::function<Roles(const std::string& name)> roles;
};

/// Summands, and the sums that stand in them as symbols.
struct LoopTerms {
    std::vector<LoopTerm> terms;
    std::map<std::string, Expression> totals;  ///< by their symbols
};

/// The expression as a sum of summands: c*(a + sum(i=1..N, b[i])) is c*a and c*b[i] for all i. What
/// has momenta stands apart from what has coordinates, where a sum of them is written. In a product
/// with another sum and inside a function, a sum of at most 16 terms is written out, and a longer
/// one becomes a symbol. Throws NoLoops for one there that has the index of a sum around it, and
/// for bounds that are not made of sizes and indices.
[[nodiscard]] LoopTerms loop_terms(const IndexedExpression& expression, const TermNames& names);

}  // namespace hvi::gen
