// The functions of expr/functions.def in GiNaC: its own, and ours where it has none.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace hvi::gen {

/// The function of these arguments, as many as it takes. Throws std::exception where it has no
/// value. NOTE: GiNaC calls the functions that it has as we do.
[[nodiscard]] GiNaC::ex applied(const std::string& function, const GiNaC::exvector& arguments);

/// Whether a function with a kink or a choice is called of something that has one of these symbols.
[[nodiscard]] bool has_kink_in(const GiNaC::ex& expression,
                               const std::vector<GiNaC::symbol>& symbols);

/// What changes its sign where the function may jump: x of sign(x), and a - b of if(a < b, y, n).
[[nodiscard]] GiNaC::exvector where_it_may_jump(const GiNaC::ex& expression);

}  // namespace hvi::gen
