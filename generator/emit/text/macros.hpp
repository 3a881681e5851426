// Names that the preprocessor replaces before a compiler sees them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen {

/// Returns whether the name is spelled like a macro: in capitals and digits, with two capitals or
/// more and no underscore at its end, as in `M_PI`, or with an underscore in front. One capital
/// with digits, as in `K`, `M1` and `M_1`, is a variable, except the `I` of <complex.h>.
/// Precondition: `name` is not empty.
[[nodiscard]] bool is_spelled_as_macro(std::string_view name);

/// Returns whether a header of the C++ standard library, a header that it includes, a header of
/// Eigen or a compiler itself may define a macro of that name: a name that is spelled like a macro,
/// or one of the few others, as `errno`, `linux` and `PRId64`. Precondition: `name` is not empty.
[[nodiscard]] bool is_macro(std::string_view name);

}  // namespace hvi::gen
