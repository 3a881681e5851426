// Names that the preprocessor replaces before a compiler sees them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen {

/// Whether a header of the C++ standard library, what it includes, a header of Eigen or a compiler
/// itself may define a macro of that name: `M_PI`, `NAN`, `errno`, `linux`. `name` is not empty.
[[nodiscard]] bool is_macro(std::string_view name);

}  // namespace hvi::gen
