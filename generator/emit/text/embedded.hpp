// Templates and parts of the runtime that are embedded in the program.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "generator/support/embedded.hpp"

namespace hvi::gen {

[[nodiscard]] std::span<const EmbeddedFile> embedded_templates();

/// Returns the text of `templates/NAME` or `src/hvi/NAME`. Precondition: there is such a file among
/// those that the build names.
[[nodiscard]] std::string_view embedded_template(std::string_view name);

}  // namespace hvi::gen
