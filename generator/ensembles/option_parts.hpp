// Texts of options that begin with a name: NAME=...
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// A name, and the text behind `=`. A name has no blanks at its ends.
struct NamedPart {
    std::string name;
    Place place;  ///< the place of the name
    Range rest;
};

/// Cuts a text at its first `=`. Throws InputError, which asks for the form, where there is none or
/// nothing before it.
[[nodiscard]] NamedPart named_part(const Given& text, const std::string& form,
                                   const std::string& example);

/// Returns the double nearest to the value of a part of a text, which may use the parameters of the
/// scene. Throws as expression_of_parameters() and nearest_value() do.
[[nodiscard]] double value_of_part(const Given& text, Range part, const SceneTimes& scene);

}  // namespace hvi::gen
