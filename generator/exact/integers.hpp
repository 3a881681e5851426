// Small help with GiNaC's exact integers and rationals.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <sstream>
#include <string>

namespace hvi::gen {

/// An exact rational as `7` or `-2/3`.
[[nodiscard]] inline std::string digits(const GiNaC::numeric& rational) {
    std::ostringstream text;
    text << rational;
    return text.str();
}

}  // namespace hvi::gen
