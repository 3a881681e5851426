// Where a function vanishes on [0, 1].
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/exact/ball.hpp"
#include "generator/exact/function.hpp"

namespace hvi::gen {

/// The proven bounds of a function's values on a ball of arguments. Precondition: no free
/// parameter.
[[nodiscard]] Ball enclosure(const ExactFunction& function, const Ball& argument, Precision bits);

/// The place of a zero in [0, 1], as `0`, `1/3` or `near 0.3090`: proved, by an exact value or a
/// change of sign. Empty when none is found, which is no proof that there is none. Precondition: no
/// free parameter, not the zero function.
[[nodiscard]] std::optional<std::string> zero_in_unit_interval(const ExactFunction& function,
                                                               const Ground& ground);

}  // namespace hvi::gen
