// What `run` and `report` have in common.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// `step` or `until`: what the command line says, else the scene. Throws InputError where neither
/// does, with what to give: `option`, or, where that is empty, an option of this name.
[[nodiscard]] NamedExpression wish(const SceneTimes& times, const Given& given,
                                   const std::optional<NamedExpression>& of_scene,
                                   const std::string& name, const std::string& option = {});

/// `1.2 ms`
[[nodiscard]] std::string duration(double seconds);

/// With those above it, where they are missing. Throws EnvironmentError.
void make_directory(const std::filesystem::path& path);

}  // namespace hvi::gen
