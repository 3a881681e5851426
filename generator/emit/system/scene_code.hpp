// The parts of a header that a scene decides: parameters, initial data, H and its derivatives.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/system/kernel_code.hpp"
#include "generator/exact/methods/curve.hpp"
#include "generator/exact/numbers/formats.hpp"
#include "generator/ir/step.hpp"
#include "generator/ir/system.hpp"
#include "generator/plan/evaluations.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Members that a header offers beside step().
struct SceneWishes {
    bool energy = false;
    bool invariants = false;
    bool evaluations = false;         ///< count of evaluations of dH/dq
    bool float128 = false;            ///< whether __float128 is a number type of the class
    bool action = false;              ///< action of the steps, and H_d^+ of the last one
    std::optional<Curve> curve = {};  ///< curve of the last step, as a member
};

/// Returns the namespace of the functions that the class calls: `std`, or that of
/// src/hvi/detail/numbers/math.hpp.
[[nodiscard]] std::string_view library(const SceneWishes& wishes);

/// Returns whether H calls functions of src/hvi/detail/numbers/more_math.hpp.
[[nodiscard]] bool calls_more_math(const System& system, const SceneWishes& wishes);

/// Throws InputError where a function of the user's own cannot be one in C++.
void check_own_names(const OwnFunctions& own);

/// Throws InputError where an invariant that is asked for has the name of another member of each
/// stepper, or is a word of C++.
void check_members(const WrittenOutScene& scene, const SceneWishes& wishes);

/// Returns the names of parameters as members of the object `parameters`.
[[nodiscard]] NodeNames parameter_names(const System& system);

/// Returns `struct Parameters`, with numbers, tables and sizes of the scene as defaults.
[[nodiscard]] std::string parameters_text(const System& system, const Step& step);

/// Kinds of vectors in states of a scene.
enum class StateVectors {
    numbers,   ///< numbers of a type that a user chooses, one for each degree of freedom
    bodies,    ///< members with the scene's names of coordinates and rotations
    any_size,  ///< std::vector
};
[[nodiscard]] StateVectors vectors_of(const System& system);

/// Returns the type of vectors of the class.
[[nodiscard]] std::string_view vector_type(const System& system);

/// Returns `struct System`, all that a stepper with this step needs of H, as straight-line code, or
/// with loops where there are no evaluations without loops.
[[nodiscard]] std::string system_text(const System& system, const SceneWishes& wishes,
                                      const Step& step, const Evaluations* evaluations);

/// Returns the lines of #include for System.
[[nodiscard]] std::string includes_of_class(const System& system, const SceneWishes& wishes,
                                            const Step& step, const Evaluations* evaluations);

/// Returns `static State initial(...)`, and the members that are asked for.
[[nodiscard]] std::string scene_members_text(const System& system, const SceneWishes& wishes,
                                             const Step& step);

/// Returns the value of an expression without symbols. Throws as evaluate_number() does.
[[nodiscard]] Rounded rounded_value(const Expression& expression);

/// Returns an expression without symbols as the initial value of a Scalar. Throws as
/// evaluate_number() and initializer() do.
[[nodiscard]] std::string initializer(const Expression& expression);

/// Returns the initial value in functions of a device, in float or double.
[[nodiscard]] std::string device_initializer(const Expression& expression);

}  // namespace hvi::gen
