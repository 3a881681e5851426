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

/// Returns the term within one more loop, the innermost. The index gets another name where its name
/// is taken, or is that of a loop around it.
[[nodiscard]] LoopTerm within_loop(LoopTerm term, const std::string& index, LoopRange range,
                                   const std::set<std::string>& taken);

/// Returns the expression with its sums written out. Throws InputError for a sum of more than 16
/// terms, or with bounds that are no numbers.
[[nodiscard]] Expression without_sums(const IndexedExpression& expression);

/// Meanings of names where sums are taken apart.
struct TermNames {
    std::set<std::string> taken;  ///< names that no index may have; it then gets another one
    /// Kinds of variables: Role::coordinate, Role::conjugate, or 0.
    std::function<Roles(const std::string& name)> roles;
};

/// Summands, and the sums in them that became symbols.
struct LoopTerms {
    std::vector<LoopTerm> terms;
    std::map<std::string, Expression> totals;  ///< by their symbols
};

/// Returns the expression as a sum of summands: c*(a + sum(i=1..N, b[i])) becomes c*a and c*b[i]
/// for all i. Summands with momenta stand apart from summands with coordinates, where their sum is
/// written. In a product with another sum and inside a function, a sum of at most 16 terms is
/// written out, and a longer one becomes a symbol. Throws NoLoops for such a sum that has the index
/// of a sum around it, and for bounds that are not made of sizes and indices.
[[nodiscard]] LoopTerms loop_terms(const IndexedExpression& expression, const TermNames& names);

}  // namespace hvi::gen
