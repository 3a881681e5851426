// Names that the preprocessor replaces before a compiler sees them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen {

/// Whether the name is spelled as names of macros are: in capitals and digits, with two capitals or
/// more and no underscore at its end, as in `M_PI`, or with an underscore in front. One capital with
/// digits, as in `K`, `M1` and `M_1`, is a variable, but for the `I` of <complex.h>. `name` is not
/// empty.
[[nodiscard]] bool is_spelled_as_macro(std::string_view name);

/// Whether a header of the C++ standard library, what it includes, a header of Eigen or a compiler
/// itself may define a macro of that name: one that is spelled so, or one of the few others, as
/// `errno`, `linux` and `PRId64`. `name` is not empty.
[[nodiscard]] bool is_macro(std::string_view name);

}  // namespace hvi::gen
