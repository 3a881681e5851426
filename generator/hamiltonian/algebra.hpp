// A Hamiltonian or a Lagrangian in GiNaC's hands: the one place where expressions become GiNaC's,
// and come back.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// H or L, and its symbols. Parameters that have a value are replaced by it.
class Algebra {
public:
    /// Throws InputError with its place for a division by zero, and where a number, a power or the
    /// derivatives of H are larger than one can use; MathError with its place where a number is not
    /// real. NOTE: entries of a rotation are no coordinates of their own, and an H that has some is
    /// refused with an InputError.
    explicit Algebra(const Hamiltonian& hamiltonian);
    explicit Algebra(const Lagrangian& lagrangian);

    /// Of an H with rotations, for whom they are variables like others. Throws the same.
    [[nodiscard]] static Algebra with_entries(const Hamiltonian& hamiltonian);

    [[nodiscard]] const GiNaC::ex& function() const { return function_; }
    /// Of its text.
    [[nodiscard]] const Place& place() const { return whole_; }
    /// Coordinates, then momenta or velocities.
    [[nodiscard]] const std::vector<GiNaC::symbol>& variables() const { return variables_; }
    /// Those without a value, and the time where it occurs: by it nothing is differentiated.
    [[nodiscard]] const std::vector<GiNaC::symbol>& parameters() const { return parameters_; }

    /// The parameters that are replaced, by name.
    [[nodiscard]] const std::map<std::string, GiNaC::ex>& values() const { return values_; }

    /// Throws InputError where it is not defined.
    [[nodiscard]] GiNaC::ex derivative(const GiNaC::ex& expression,
                                       const GiNaC::symbol& variable) const;

    /// Another expression of the same variables and parameters, which stands in `source`; one that
    /// is new to the algebra is a parameter without a value. Throws as the constructor does.
    [[nodiscard]] GiNaC::ex read(const Expression& expression,
                                 const std::shared_ptr<const Source>& source);

    /// The expression as one would write it. NOTE: GiNaC orders terms, and the sign of a sum in a
    /// power, by addresses in memory; here both depend on the expression alone.
    [[nodiscard]] Expression written(const GiNaC::ex& expression) const;

private:
    Algebra(const Expression& function, const std::shared_ptr<const Source>& source,
            const std::vector<Parameter>& parameters, const std::vector<std::string>& variables);
    void add(const std::string& name, char kind, std::vector<GiNaC::symbol>& list);

    Place whole_;
    std::vector<GiNaC::symbol> variables_;
    std::vector<GiNaC::symbol> parameters_;
    std::map<std::string, GiNaC::ex> values_;
    std::map<std::string, GiNaC::ex> symbols_;  ///< and values, by name
    std::map<std::string, std::string> ranks_;  ///< of symbols, by name: as text that sorts so
    GiNaC::ex function_;
};

}  // namespace hvi::gen
