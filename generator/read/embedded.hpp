// Scenes that come with the program.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "generator/support/embedded.hpp"

namespace hvi::gen {

/// The files of examples/scenes, as the build names them.
[[nodiscard]] std::span<const EmbeddedFile> embedded_scenes();

}  // namespace hvi::gen
