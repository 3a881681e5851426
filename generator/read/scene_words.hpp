// Names that a scene declares, and its expressions with their sums written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/read/put_in.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// What may stand in an expression besides parameters, pi and e.
struct SceneRules {
    std::string_view subject;  ///< what messages call it
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

/// Names are declared one kind after the other: variables, parameters, definitions.
class SceneWords {
public:
    explicit SceneWords(const Scene& written);

    [[nodiscard]] const WholeNumbers& sizes() const { return sizes_; }
    [[nodiscard]] const Vocabulary& names() const { return names_; }

    void declare_variables(const VariableNames& names);

    /// Declares the names of variables without their indices, as in times no variable may stand.
    void declare_stems();

    /// Declares parameters, and returns those that are no sizes, with the values of others put in.
    /// Without `files` those whose values stand in files are left out.
    [[nodiscard]] std::vector<Parameter> declare_parameters(bool files = true);

    /// Definitions, each with those above it put in.
    void define();

    /// The expression with `indices` and sizes for numbers, and definitions put in. Throws
    /// InputError where the rules forbid a word, and for a scene of more than 300 000 words.
    [[nodiscard]] NamedExpression expression(std::string name, const IndexedExpression& written,
                                             const SceneRules& rules,
                                             const WholeNumbers& indices = {});

private:
    [[nodiscard]] ValueList values_of(const IndexedValue& value) const;
    void add_parameter(std::vector<Parameter>& list, const IndexedValue& value, std::string name,
                       const IndexedExpression& written);
    void add_parameters(std::vector<Parameter>& list, const IndexedValue& value);
    void check_words(const Expression& expression, const std::shared_ptr<const Source>& source,
                     const SceneRules& rules);

    const Scene& written_;
    WholeNumbers sizes_;
    Vocabulary names_;  ///< variables, then parameters too
    Definitions definitions_;
    std::size_t word_count_ = 0;
};

}  // namespace hvi::gen
