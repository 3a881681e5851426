// The parts of the chapter on extreme orbits.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/edges/edges.hpp"
#include "generator/edges/forms.hpp"
#include "generator/edges/passage.hpp"
#include "generator/edges/program.hpp"

namespace hvi::gen {

/// A method, the known facts about it, and its programs.
struct ExtremeMethod {
    std::string name;
    std::size_t parts = 1;  ///< steps of one method in a row that make a step
    KnownOrder order;
    EdgeProgram kepler;
    std::vector<std::vector<Form>> scaled;  ///< forms for each of the scaled scenes, if stepped
    EdgeProgram two_bodies, three_bodies;
};

/// Make programs. All throw as EdgeProgram() does.
[[nodiscard]] EdgeProgram kepler_program(Builds& builds, const ComposedMethod& method);
[[nodiscard]] std::vector<std::vector<Form>> scaled_forms(Builds& builds,
                                                          const ExactMethod& method);
[[nodiscard]] EdgeProgram two_bodies_program(Builds& builds, const ComposedMethod& method);
[[nodiscard]] EdgeProgram three_bodies_program(Builds& builds, const ComposedMethod& method);

/// Add the cases of one method, and curves to pictures of the chapter. All throw as
/// EdgeProgram::ask() does.
void add_kepler(const ExtremeMethod& method, EdgeChapter& chapter);
void add_scaled(const ExtremeMethod& method, EdgeChapter& chapter);
void add_bodies(const ExtremeMethod& method, EdgeChapter& chapter);

/// Returns the scene in a text of a scene file.
[[nodiscard]] Scene scene_of(const std::string& text);

/// Whether the end is ok and finite, or has a status and the state before the step in every bit.
[[nodiscard]] bool is_whole(const Heard& heard);
inline constexpr const char* ends_well = "ok and finite, or a status and the state untouched";

/// Returns the outcome of the steps in a few words.
[[nodiscard]] std::string end_text(const Heard& heard);

/// Returns the curve of this method in the picture with this title. Adds the picture where there is
/// none.
CurvesPicture::Curve& curve_of(const ExtremeMethod& method, EdgeChapter& chapter,
                               const CurvesPicture& picture);

}  // namespace hvi::gen
