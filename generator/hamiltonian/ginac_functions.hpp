// The functions of expr/functions.def in GiNaC: its own where it has them, else ours.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace hvi::gen {

/// Applies a function to as many arguments as it takes. Throws std::exception where it has no
/// value. NOTE: GiNaC's functions have our names.
[[nodiscard]] GiNaC::ex applied(const std::string& function, const GiNaC::exvector& arguments);

/// Whether the argument of a function with a kink or a choice has one of these symbols.
[[nodiscard]] bool has_kink_in(const GiNaC::ex& expression,
                               const std::vector<GiNaC::symbol>& symbols);

/// Returns the expressions at whose zeros the function may jump: x of sign(x), and a - b of if(a <
/// b, y, n).
[[nodiscard]] GiNaC::exvector where_it_may_jump(const GiNaC::ex& expression);

}  // namespace hvi::gen
