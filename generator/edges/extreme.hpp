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

/// A method, what is known of it beforehand, and its programs.
struct ExtremeMethod {
    std::string name;
    std::size_t parts = 1;  ///< steps of one method in a row that make a step
    KnownOrder order;
    EdgeProgram kepler;
    std::vector<std::vector<Form>> scaled;  ///< of each of the scaled scenes, if stepped
    EdgeProgram two_bodies, three_bodies;
};

/// All throw what EdgeProgram() does.
[[nodiscard]] EdgeProgram kepler_program(Builds& builds, const ComposedMethod& method);
[[nodiscard]] std::vector<std::vector<Form>> scaled_forms(Builds& builds,
                                                          const ExactMethod& method);
[[nodiscard]] EdgeProgram two_bodies_program(Builds& builds, const ComposedMethod& method);
[[nodiscard]] EdgeProgram three_bodies_program(Builds& builds, const ComposedMethod& method);

/// These add their cases for one method, and curves to pictures of the chapter. All throw what
/// EdgeProgram::ask() does.
void add_kepler(const ExtremeMethod& method, EdgeChapter& chapter);
void add_scaled(const ExtremeMethod& method, EdgeChapter& chapter);
void add_bodies(const ExtremeMethod& method, EdgeChapter& chapter);

/// The scene in a text as files have it.
[[nodiscard]] Scene scene_of(const std::string& text);

/// Whether the end is ok and finite, or a status and every bit of the state as it was before the
/// step.
[[nodiscard]] bool is_whole(const Heard& heard);
inline constexpr const char* ends_well = "ok and finite, or a status and the state untouched";

/// What became of the steps, in a few words.
[[nodiscard]] std::string end_text(const Heard& heard);

/// The curve of this method in the picture with this title, which is added where there is none.
CurvesPicture::Curve& curve_of(const ExtremeMethod& method, EdgeChapter& chapter,
                               const CurvesPicture& picture);

}  // namespace hvi::gen
