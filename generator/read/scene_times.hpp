// Times of a scene: its steps, and the end of its run.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Times of [run], and the parameters that they may use.
struct SceneTimes {
    std::vector<Parameter> parameters;  ///< without those whose values stand in files
    WholeNumbers sizes;
    std::optional<NamedExpression> step;   ///< a function of parameters, pi and e
    std::optional<NamedExpression> until;  ///< a function like `step`
    std::optional<Place> place;            ///< the place of the word that names the scene
};

/// Throws InputError where a word has no meaning, as unrolled() does.
[[nodiscard]] SceneTimes times_of(const Scene& scene);

/// Reads a number that may depend on the scene's parameters, as [run] has it: the value of
/// `--step`. Throws InputError.
[[nodiscard]] NamedExpression expression_of_parameters(const SceneTimes& times, std::string name,
                                                       std::shared_ptr<const Source> text);

/// Reads such a number in a part of a text.
[[nodiscard]] NamedExpression expression_of_parameters(const SceneTimes& times, std::string name,
                                                       Place part);

}  // namespace hvi::gen
