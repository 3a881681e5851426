// The value of a rotation in a scene file: as the identity, as a turn about an axis, as a
// quaternion.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"
#include "generator/read/toml_file.hpp"

namespace hvi::gen {

/// Reads `"identity"`, `{axis = [0, 0, 1], angle = "pi/3"}` or `{quaternion = [1, 0, 0, 0]}`, with
/// calls of `own` functions. Throws InputError with its place for anything else, and for an axis or
/// a quaternion of zeros.
[[nodiscard]] RotationValue rotation_in(const toml::node& node, const TomlFile& file,
                                        const OwnArguments& own);

}  // namespace hvi::gen
