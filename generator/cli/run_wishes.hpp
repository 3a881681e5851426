// Common parts of `run`, `report` and `ensemble`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// Returns `step` or `until`: the value of the command line, else that of the scene. Throws
/// InputError where neither has it; the help names `option`, or, where that is empty, an option
/// with this name.
[[nodiscard]] NamedExpression wish(const SceneTimes& times, const Given& given,
                                   const std::optional<NamedExpression>& of_scene,
                                   const std::string& name, const std::string& option = {});

/// Returns `1.2 ms`.
[[nodiscard]] std::string duration(double seconds);

/// Returns what steps of so many counted sweeps are.
[[nodiscard]] std::string sweeps_text(int sweeps);

/// Makes a directory and the missing ones above it. Throws EnvironmentError.
void make_directory(const std::filesystem::path& path);

}  // namespace hvi::gen
