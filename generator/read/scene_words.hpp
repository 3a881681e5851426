// Names that a scene declares, and its expressions with their sums written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/read/put_in.hpp"
#include "generator/read/scene_rules.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// The names of a scene. They are declared one kind after the other: variables, parameters,
/// definitions.
class SceneWords {
public:
    explicit SceneWords(const Scene& written);

    [[nodiscard]] const WholeNumbers& sizes() const { return sizes_; }
    [[nodiscard]] const Vocabulary& names() const { return names_; }

    void declare_variables(const VariableNames& names);

    /// Declares the stems of variables, so that an expression of a time that uses a variable is
    /// refused.
    void declare_stems();

    /// Declares parameters. Returns those that are no sizes, with the values of others put in;
    /// without `files`, also leaves out those whose values stand in files.
    [[nodiscard]] std::vector<Parameter> declare_parameters(bool files = true);

    /// Adds the definitions. Each may use those above it.
    void define();

    /// Returns the expression with numbers for `indices` and sizes, and with definitions put in.
    /// Throws InputError where the rules forbid a word, and for a scene of more than 300 000 words.
    [[nodiscard]] NamedExpression expression(std::string name, const IndexedExpression& written,
                                             const SceneRules& rules,
                                             const WholeNumbers& indices = {});

private:
    [[nodiscard]] ValueList values_of(const IndexedValue& value) const;
    void add_parameter(std::vector<Parameter>& list, const IndexedValue& value, std::string name,
                       const IndexedExpression& written);
    void add_parameters(std::vector<Parameter>& list, const IndexedValue& value);
    void check_indices(const Expression& expression, const std::shared_ptr<const Source>& source);

    const Scene& written_;
    WholeNumbers sizes_;
    Vocabulary names_;  ///< variables, then parameters too
    Definitions definitions_;
    std::size_t word_count_ = 0;
};

}  // namespace hvi::gen
