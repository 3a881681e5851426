// What compiled programs include, which is part of hvi-gen.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "generator/support/embedded.hpp"

namespace hvi::gen {

/// The headers of src/hvi.
[[nodiscard]] std::span<const EmbeddedFile> embedded_runtime();

/// The headers of src/driver.
[[nodiscard]] std::span<const EmbeddedFile> embedded_drivers();

}  // namespace hvi::gen
