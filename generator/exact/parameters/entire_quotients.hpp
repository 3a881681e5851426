// Quotients of entire functions of a free parameter, from numbers that depend on it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/parameters/parameter_generators.hpp"
#include "generator/exact/parameters/parametric.hpp"

namespace hvi::gen {

/// Collects the functions whose quotients some numbers are, each once.
class EntireQuotients {
public:
    /// Throws as `parametric` does, and has its preconditions.
    explicit EntireQuotients(const std::vector<Number>& numbers) : generators_(numbers) {}

    /// Returns the quotient of a number. Precondition: it is one of the numbers. Its numerator
    /// counts from the first numerator on.
    [[nodiscard]] Quotient add(const Number& number);

    /// Returns all functions, and these quotients, which add() returned. Orders and zeros at w = 0,
    /// places of zeros and the plan of the series are left open.
    [[nodiscard]] ParametricNumbers finish(std::vector<Quotient> weights,
                                           std::vector<Quotient> others) &&;

    [[nodiscard]] const ParameterGenerators& generators() const { return generators_; }

private:
    /// For each phase, the degree of the denominator less that of the numerator.
    using Surplus = std::vector<int>;

    [[nodiscard]] Surplus divide_by(const IntegerMultivariate& denominator, Quotient& quotient);
    void balance(EntireFunction& numerator, const Surplus& surplus, Quotient& quotient);
    void factor(Quotient& quotient, const EntireFunction& function, unsigned exponent);

    [[nodiscard]] std::size_t phase_count() const { return generators_.entire().phases.size(); }
    [[nodiscard]] std::size_t variable(std::size_t phase) const {
        return generators_.phase_variables()[phase];
    }
    [[nodiscard]] bool is_secant(const IntegerMultivariate& base) const;
    [[nodiscard]] unsigned degree_of(const Element::Terms& polynomials, std::size_t phase) const;
    [[nodiscard]] EntireFunction generator(std::size_t which) const;
    [[nodiscard]] EntireFunction homogeneous(const Element::Terms& polynomials) const;
    [[nodiscard]] std::vector<unsigned> powers_of(const std::vector<unsigned>& variables,
                                                  const Monomial& algebraics) const;
    [[nodiscard]] bool has_zeros(const EntireFunction& function) const;

    ParameterGenerators generators_;
    std::vector<EntireFunction> factors_;
    std::vector<EntireFunction> numerators_;
};

}  // namespace hvi::gen
