// The functions of expr/functions.def in GiNaC: its own, and ours where it has none.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace hvi::gen {

/// The function of these arguments, as many as it takes. Throws std::exception where it has no
/// value. NOTE: GiNaC calls the functions that it has as we do.
[[nodiscard]] GiNaC::ex applied(const std::string& function, const GiNaC::exvector& arguments);

}  // namespace hvi::gen
