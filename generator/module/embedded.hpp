// Files of the package hvi for packages in Python, which are part of hvi-gen.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "generator/support/embedded.hpp"

namespace hvi::gen {

/// Returns the files of python/hvi that steppers need, by their names there.
[[nodiscard]] std::span<const EmbeddedFile> embedded_python();

}  // namespace hvi::gen
