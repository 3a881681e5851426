// Scenes of any size: written out, or with sums that stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "generator/read/unrolling.hpp"

namespace hvi::gen {

/// A scene that is written out, or whose sums stay loops, and why.
struct SceneOfAnySize {
    std::variant<WrittenOutScene, Scene> scene;
    UnrollDecision unrolling;
};

/// The scene that the command line names, as find_indexed_scene() finds it. What loops turn out not
/// to have is written out, where nothing else was wished for and it is not too large. Throws
/// InputError as unroll_decision() and unrolled() do.
[[nodiscard]] SceneOfAnySize find_scene_of_any_size(const Given& name_or_file,
                                                    const std::vector<Parameter>& values = {},
                                                    const UnrollWish& wish = {});

}  // namespace hvi::gen
