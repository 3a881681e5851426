// A Hamiltonian or a Lagrangian in GiNaC's form. Expressions become GiNaC's, and come back, here
// only.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// H or L with its symbols. Parameters with a value are replaced by the value.
class Algebra {
public:
    /// Throws InputError with its place for a division by zero, and where a number, a power or the
    /// derivatives of H are too large; MathError with its place where a number is not real. NOTE:
    /// entries of a rotation are no coordinates of their own, so an H with rotations is refused
    /// with an InputError.
    explicit Algebra(const Hamiltonian& hamiltonian);
    explicit Algebra(const Lagrangian& lagrangian);

    /// Makes the algebra of an H with rotations. Their nine entries are treated as ordinary
    /// variables. Throws as the constructor does.
    [[nodiscard]] static Algebra with_entries(const Hamiltonian& hamiltonian);

    [[nodiscard]] const GiNaC::ex& function() const { return function_; }
    /// Returns the place of the text of H or L.
    [[nodiscard]] const Place& place() const { return whole_; }
    /// Returns coordinates, then momenta or velocities.
    [[nodiscard]] const std::vector<GiNaC::symbol>& variables() const { return variables_; }
    /// Returns parameters without a value, and the time where it occurs. Nothing is differentiated
    /// by them.
    [[nodiscard]] const std::vector<GiNaC::symbol>& parameters() const { return parameters_; }

    /// Returns the parameters that are replaced by their values, by name.
    [[nodiscard]] const std::map<std::string, GiNaC::ex>& values() const { return values_; }

    /// Throws InputError where the derivative is not defined.
    [[nodiscard]] GiNaC::ex derivative(const GiNaC::ex& expression,
                                       const GiNaC::symbol& variable) const;

    /// Reads another expression of the variables and parameters, which stands in `source`. A symbol
    /// that is new to the algebra becomes a parameter without a value. Throws as the constructor
    /// does.
    [[nodiscard]] GiNaC::ex read(const Expression& expression,
                                 const std::shared_ptr<const Source>& source);

    /// Returns the expression as one would write it. NOTE: GiNaC orders terms, and chooses the sign
    /// of a sum in a power, by addresses in memory; here both depend on the expression alone.
    [[nodiscard]] Expression written(const GiNaC::ex& expression) const;

private:
    Algebra(const Expression& function, const std::shared_ptr<const Source>& source,
            const std::vector<Parameter>& parameters, const std::vector<std::string>& variables);
    void add(const std::string& name, char kind, std::vector<GiNaC::symbol>& list);

    Place whole_;
    std::vector<GiNaC::symbol> variables_;
    std::vector<GiNaC::symbol> parameters_;
    std::map<std::string, GiNaC::ex> values_;
    std::map<std::string, GiNaC::ex> symbols_;  ///< symbols and values, by name
    std::map<std::string, std::string> ranks_;  ///< texts that sort as symbols do, by their names
    GiNaC::ex function_;
};

}  // namespace hvi::gen
