// The generators of a field that occur in numbers with a free parameter.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/exact/numbers/field.hpp"
#include "generator/exact/parameters/entire.hpp"

namespace hvi::gen {

/// Generators of a field that occur in some numbers, and their places among EntireGenerators.
class ParameterGenerators {
public:
    /// Throws as `parametric` does, and has its preconditions.
    explicit ParameterGenerators(const std::vector<Number>& numbers);

    [[nodiscard]] const std::string& parameter() const { return name_; }
    [[nodiscard]] const EntireGenerators& entire() const { return entire_; }
    [[nodiscard]] Number exact(Element element) const;
    [[nodiscard]] Number pi() const { return exact(field_->pi()); }

    /// Returns the variable of w in polynomials.
    [[nodiscard]] std::size_t parameter_variable() const { return parameter_; }
    /// Returns the variables of the phases, where t = x/y.
    [[nodiscard]] const std::vector<std::size_t>& phase_variables() const { return phases_; }
    [[nodiscard]] std::optional<std::size_t> phase_of(std::size_t variable) const;
    [[nodiscard]] bool is_angle(std::size_t variable) const;
    [[nodiscard]] std::vector<std::size_t> angles() const;  ///< those of phases that are angles

    /// Returns the place of a constant in EntireGenerators::constants.
    [[nodiscard]] std::size_t constant(std::size_t variable) const {
        return constants_.at(variable);
    }
    [[nodiscard]] std::size_t algebraic_constant(std::size_t index) const {
        return algebraic_constants_.at(index);
    }

private:
    void note(const Number& number);
    void note_monomial(const Monomial& monomial);
    void note_transcendentals(const IntegerMultivariate& polynomial);
    void set_parameter(std::size_t index);
    void add_transcendental(std::size_t index);
    void add_algebraic(std::size_t index);
    [[nodiscard]] Number rate(const Element& argument) const;

    std::shared_ptr<Field> field_;
    std::string name_;
    std::size_t parameter_ = 0;
    std::vector<std::size_t> transcendentals_, algebraics_;  ///< generators that occur, sorted
    std::vector<std::size_t> phases_;
    std::map<std::size_t, std::size_t> constants_, algebraic_constants_;
    EntireGenerators entire_;
};

}  // namespace hvi::gen
