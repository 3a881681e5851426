// Rules for the words of a scene: their meanings, and the expressions that they may stand in.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "generator/read/parse.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/vocabulary.hpp"

namespace hvi::gen {

/// Words that may stand in an expression besides parameters, pi and e.
struct SceneRules {
    std::string_view subject;  ///< the expression's name in messages
    bool variables = false;
    bool time = false;
    bool own_functions = false;
    std::string_view help;  ///< for a symbol that resembles no other
};

inline constexpr std::string_view made_of_parameters =
    "it is made of numbers, parameters, pi and e";
inline constexpr SceneRules hamiltonian_rules{"the Hamiltonian", true, true, true,
                                              "give it a value: add it to [parameters]"};
inline constexpr SceneRules lagrangian_rules{"the Lagrangian", true, true, false,
                                             "give it a value: add it to [parameters]"};
inline constexpr SceneRules parameter_rules{"the value of a parameter", false, false, false,
                                            made_of_parameters};
inline constexpr SceneRules invariant_rules{"an invariant", true, false, true,
                                            "add it to [parameters]"};
inline constexpr SceneRules part_rules{"a part of the Hamiltonian", true, true, true,
                                       "add it to [parameters]"};
inline constexpr SceneRules event_rules{"the zero of an event", true, true, false,
                                        "add it to [parameters]"};
inline constexpr SceneRules jump_rules{"what an event sets", true, true, false,
                                       "add it to [parameters]"};
inline constexpr SceneRules scale_rules{"the scale of the time", true, true, false,
                                        "add it to [parameters]"};
inline constexpr SceneRules cooldown_rules{"a cooldown", false, false, false, made_of_parameters};
inline constexpr SceneRules period_rules{"a period", false, false, false, made_of_parameters};
inline constexpr SceneRules field_rules{"a vector field", true, false, false,
                                        "add it to [parameters]"};
inline constexpr SceneRules initial_rules{"an initial value", false, false, false,
                                          made_of_parameters};
inline constexpr SceneRules exact_rules{
    "an exact solution", false, true, false,
    "it is made of numbers, parameters, pi, e and the time `t`"};
inline constexpr SceneRules step_rules{"the step size", false, false, false, made_of_parameters};
inline constexpr SceneRules until_rules{"the time at the end", false, false, false,
                                        made_of_parameters};

/// Returns `a momentum`, or `a velocity`.
[[nodiscard]] std::string_view subject_of_conjugates(const Scene& scene);

/// Returns the rules for H, or for L.
[[nodiscard]] const SceneRules& rules_of_function(Side side);

/// Throws InputError at `place` where a rule for the values of a family has another number of
/// indices than the family.
void check_dimension(const std::string& family, std::size_t wanted, std::size_t given,
                     const Place& place, std::string help = "");

/// Throws InputError for a definition with the name of a variable or a parameter.
void check_definition(const Definition& definition, const Vocabulary& names);

/// Throws InputError for an invalid name of an invariant or of [symmetries], and for one that is
/// taken.
void check_more_names(const Scene& scene, Vocabulary names);

/// Throws InputError for a word that names nothing, or that the rules forbid. `known` are indices
/// and sizes; words in indices are not checked.
void check_words(const IndexedExpression& expression, const SceneRules& rules,
                 const Vocabulary& names, std::set<std::string> known);

}  // namespace hvi::gen
