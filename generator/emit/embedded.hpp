// Files that are part of the program.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen {

/// The text of `templates/NAME` or `src/hvi/NAME` as it stood when the program was built.
/// Precondition: there is such a file among those that the build names.
[[nodiscard]] std::string_view embedded_template(std::string_view name);

}  // namespace hvi::gen
