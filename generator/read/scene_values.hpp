// Values of variables by name, as sections of a scene give them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/read/scene_words.hpp"

namespace hvi::gen {

/// Variables of a scene.
struct SceneVariables {
    std::vector<std::string> names;        ///< coordinates, then the others
    std::vector<RotationNames> rotations;  ///< whose entries are among them
};

/// Values that are given to variables: singly, as lists, by a rule for all indices, as rotations.
class SceneValues {
public:
    SceneValues(SceneWords& words, const SceneVariables& variables, const SceneRules& rules)
        : words_(words), variables_(variables), rules_(rules) {}

    /// Adds the values of a line of the section, by ascending index. Throws InputError for a name
    /// that is no variable, a value that is given twice, and a number of values that differs from
    /// the number of indices.
    void add(const IndexedValue& value);

    /// Returns the values so far, by the names of variables.
    [[nodiscard]] const std::map<std::string, NamedExpression>& found() const { return found_; }

private:
    void put(const IndexedValue& value, const std::string& name, const IndexedExpression& written,
             const WholeNumbers& indices = {});
    void add_list(const IndexedValue& value, const ValueList& list,
                  const std::vector<Index>& indices);
    void add_rule(const IndexedValue& value, const ValueRule& rule,
                  const std::vector<Index>& indices);
    [[nodiscard]] bool is_momentum_of_body(const std::string& name) const;
    void add_momentum_of_body(const IndexedValue& value);
    void add_rotation(const IndexedValue& value, const RotationValue& rotation);
    [[noreturn]] void refuse_variable(const std::string& name, const Place& place) const;

    SceneWords& words_;
    const SceneVariables& variables_;
    const SceneRules& rules_;
    std::map<std::string, NamedExpression> found_;
};

/// Returns a value for each variable: for the coordinates, then for the others. Throws InputError
/// where one is missing, and as SceneValues::add() does.
[[nodiscard]] std::vector<NamedExpression> values(const ValueTable& table, SceneWords& words,
                                                  const SceneVariables& variables,
                                                  const SceneRules& rules);

}  // namespace hvi::gen
