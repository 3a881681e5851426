// Parts of the H of a scene, as `hvi-gen list splits` tells of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/cli/options.hpp"

namespace hvi::gen {

/// Returns the parts, their flows, and what these keep. Throws as in_parts() does.
[[nodiscard]] std::string splits_of(const SystemOptions& system);

}  // namespace hvi::gen
