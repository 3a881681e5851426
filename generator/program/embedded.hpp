// Headers for compiled programs, which are part of hvi-gen.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "generator/support/embedded.hpp"

namespace hvi::gen {

/// Returns the headers of src/hvi and src/driver, by their paths in src/.
[[nodiscard]] std::span<const EmbeddedFile> embedded_headers();

}  // namespace hvi::gen
