// The tableaux that the tests of the formats print.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "tests/generator/exact/exact.hpp"

namespace hvi::gen {

inline Tableau tableau(const std::string& basis, const std::string& nodes) {
    return derive(method(basis, nodes));
}

}  // namespace hvi::gen
