// Methods that are refused, and the status that a user sees then.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "tests/generator/exact/exact.hpp"

namespace hvi::gen {

inline constexpr int mathematics = 1;
inline constexpr int input = 2;

inline Refusal refused(const std::string& basis, const std::string& nodes) {
    return refusal([&] { return derive(method(basis, nodes)); });
}

}  // namespace hvi::gen
