// What the user said as a Hamiltonian: its expression, and which of its symbols are variables.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/expr/space.hpp"
#include "generator/read/method.hpp"
#include "generator/read/rotations.hpp"
#include "generator/read/unroll.hpp"

namespace hvi::gen {

/// The most degrees of freedom that a function without loops can have: there is an entry for each
/// two of them in the matrix of its second derivatives.
constexpr std::size_t most_degrees_of_freedom = 256;

/// What a Hamiltonian and a Lagrangian have in common: a function of coordinates, of as many other
/// variables, of parameters and of the time, as it was given, checked as far as words go. Names of
/// variables are free and differ, and nothing stands in it that cannot be differentiated. Sums are
/// expanded, and an index is part of a name: `x[1]`.
struct MechanicalFunction {
    Expression expression;
    std::shared_ptr<const Source>
        source;  ///< its text: the ranges in `expression` are ranges there
    std::vector<std::string> coordinates;
    std::vector<RotationNames> rotations;  ///< whose entries are the last of the variables
    std::vector<Parameter> parameters;  ///< each a symbol of it that is no variable, no name twice
    WholeNumbers sizes;                 ///< structural parameters: numbers in all that stands here
    std::string origin;  ///< as the command line has it, without parameters; one line of ASCII

    [[nodiscard]] std::size_t degrees_of_freedom() const {
        return coordinates.size() -
               (rotations_of_space.point - rotations_of_space.tangent) * rotations.size();
    }
};

/// H(q, p) or H(q, p, t), and of rotations H(q, R, p, L).
struct Hamiltonian : MechanicalFunction {
    /// momenta[i] belongs to coordinates[i], up to the entries of rotations.
    std::vector<std::string> momenta;
};

/// Variables in pairs: coordinates and momenta, rotations and angular momenta.
struct VariableNames {
    NameList coordinates, conjugates;
    NameList rotations = {}, angular_momenta = {};  ///< without the indices of their entries
};

/// The Hamiltonian of `--hamiltonian`, `--coordinates` and `--momenta`. Without the last two its
/// variables are q and p, or the pairs q1 and p1, q2 and p2, ... of which one at least occurs. What
/// stands in indices and ranges has its value among `values`. Throws InputError. Precondition: both
/// lists of names are given, or none.
[[nodiscard]] Hamiltonian
hamiltonian_from_text(std::shared_ptr<const Source> expression,
                      const std::shared_ptr<const Source>& coordinates = nullptr,
                      const std::shared_ptr<const Source>& momenta = nullptr,
                      const std::vector<Parameter>& values = {});

/// The same of an expression that stands in `source`, and of variables whose names stand anywhere;
/// `origin` is left empty.
[[nodiscard]] Hamiltonian hamiltonian_of(Expression expression,
                                         std::shared_ptr<const Source> source,
                                         const VariableNames& names);

/// What the variables are called that belong to the coordinates.
struct ConjugateWords {
    std::string_view subject;  ///< `a momentum`
    std::string_view singular, plural;
};
constexpr ConjugateWords words_of_momenta{"a momentum", "momentum", "momenta"};

/// The names of variables, declared. Throws InputError for names that are reserved or given twice,
/// for too many, and where coordinates and the variables that belong to them are no pairs.
[[nodiscard]] Vocabulary declared_variables(const NameList& coordinates, const NameList& conjugate,
                                            const ConjugateWords& words = words_of_momenta);

/// The same of all of them, with the entries of rotations.
[[nodiscard]] Vocabulary declared_variables(const VariableNames& names);

/// Without their places.
[[nodiscard]] std::vector<std::string> texts(const NameList& list);

/// Throws InputError for what cannot stand in a function of these variables, of parameters and of
/// the time, and for too many parameters. `subject` is what messages call it: `a Hamiltonian`.
void check_words_of(const Expression& function, const std::shared_ptr<const Source>& source,
                    const Vocabulary& variables, std::string_view subject);

/// Throws InputError for what cannot stand in an expression of variables and parameters: `roots`,
/// `bspline`. `subject` is what messages call it.
void check_functions(const Expression& expression, const std::shared_ptr<const Source>& source,
                     std::string_view subject);

/// Coordinates, then momenta.
[[nodiscard]] std::vector<std::string> variables(const Hamiltonian& hamiltonian);

/// The symbols of H that are parameters, with a value or without, sorted.
[[nodiscard]] std::vector<std::string> parameter_names(const Hamiltonian& hamiltonian);

/// Those of any function of variables.
[[nodiscard]] std::vector<std::string> parameter_names(const Expression& function,
                                                       const std::vector<std::string>& variables);

/// Whether the time `t` occurs in H, and is no coordinate.
[[nodiscard]] bool depends_on_time(const Hamiltonian& hamiltonian);
[[nodiscard]] bool depends_on_time(const Expression& function);

/// Throws InputError where a parameter of the method is called as a variable of H is. (A parameter
/// of the same name in both is one parameter.)
void check_together(const Method& method, const Hamiltonian& hamiltonian);

/// The same for other variables; `owner` is what messages call what has them: `the Lagrangian`.
void check_together(const Method& method, const std::vector<std::string>& variables,
                    std::string_view owner);

/// Gives a value to a symbol wherever it occurs, in place of one that it has. Throws InputError
/// when it is a variable, and when neither the method nor H has it. NOTE: a size has had its value
/// since H was read.
void set_parameter(Method& method, Hamiltonian& hamiltonian, Parameter parameter);

/// Throws InputError for a parameter that is none of `names`; `owner` is what messages call what
/// has the variables.
[[noreturn]] void refuse_parameter(const Parameter& parameter,
                                   const std::vector<std::string>& variables,
                                   std::string_view owner, const std::vector<std::string>& names);

}  // namespace hvi::gen
