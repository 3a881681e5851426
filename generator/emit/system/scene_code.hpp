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

/// What a header is to offer beside step().
struct SceneWishes {
    bool energy = false;
    bool invariants = false;
    bool evaluations = false;         ///< of dH/dq, counted
    bool float128 = false;            ///< among the numbers that it computes in
    bool action = false;              ///< of the steps, and H_d^+ of the last one
    std::optional<Curve> curve = {};  ///< of the last step, as a member
};

/// The namespace of the functions that it calls: `std`, or that of src/hvi/detail/numbers/math.hpp.
[[nodiscard]] std::string_view library(const SceneWishes& wishes);

/// Whether H calls what src/hvi/detail/numbers/more_math.hpp has.
[[nodiscard]] bool calls_more_math(const System& system, const SceneWishes& wishes);

/// Throws InputError where a function of the user's own cannot be one in C++.
void check_own_names(const OwnFunctions& own);

/// Throws InputError where an invariant that is asked for is called as something else that each
/// stepper has, or is a word of C++.
void check_members(const WrittenOutScene& scene, const SceneWishes& wishes);

/// The parameters where `parameters` is an object of the struct.
[[nodiscard]] NodeNames parameter_names(const System& system);

/// `struct Parameters`, with numbers, tables and sizes of the scene as defaults.
[[nodiscard]] std::string parameters_text(const System& system);

/// Vectors that states of a scene hold.
enum class StateVectors {
    numbers,   ///< of a type that a user chooses, with as many as there are degrees of freedom
    bodies,    ///< members that are called as the scene calls coordinates and rotations
    any_size,  ///< std::vector
};
[[nodiscard]] StateVectors vectors_of(const System& system);

/// Type of vectors of the class.
[[nodiscard]] std::string_view vector_type(const System& system);

/// `struct System`: what a stepper with this step needs of H, as straight-line code, or with loops
/// where there are no evaluations without.
[[nodiscard]] std::string system_text(const System& system, const SceneWishes& wishes,
                                      const Step& step, const Evaluations* evaluations);

/// Lines of #include for that.
[[nodiscard]] std::string includes_of_class(const System& system, const SceneWishes& wishes,
                                            const Step& step, const Evaluations* evaluations);

/// `static State initial(...)`, and the members that are asked for.
[[nodiscard]] std::string scene_members_text(const System& system, const SceneWishes& wishes,
                                             const Step& step);

/// The value of an expression without symbols. Throws as evaluate_number() does.
[[nodiscard]] Rounded rounded_value(const Expression& expression);

/// The value of an expression without symbols as a Scalar is initialised with it. Throws as
/// evaluate_number() and initializer() do.
[[nodiscard]] std::string initializer(const Expression& expression);

}  // namespace hvi::gen
