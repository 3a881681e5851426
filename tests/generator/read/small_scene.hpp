// Scenes that come with the program, as small as tests that write them out want them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/read/written_out_scene.hpp"
#include "tests/generator/read/refusal.hpp"

namespace hvi::gen {

/// The scene, with N = 4 where it is large.
inline WrittenOutScene small_scene(const SceneEntry& entry) {
    constexpr std::size_t few = 64;
    const Given name = source(std::string(entry.name), "SCENE");
    if (entry.degrees_of_freedom <= few) { return unrolled(find_scene(name)); }
    return unrolled(find_scene(name, {parse_parameter(source("N=4", "--param"))}));
}

}  // namespace hvi::gen
