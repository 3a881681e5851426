// Hamiltonians as the user gave them: an expression, and which of its symbols are variables.
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

/// The most degrees of freedom of a function without loops: the matrix of second derivatives has an
/// entry for each two of them.
constexpr std::size_t most_degrees_of_freedom = 256;

/// The common part of a Hamiltonian and a Lagrangian: a function of coordinates, of as many
/// conjugate variables, of parameters and of the time, as it was given. Its words are checked:
/// names of variables are free and differ, and every function in it can be differentiated. Sums are
/// expanded, and an index is part of a name: `x[1]`.
struct MechanicalFunction {
    Expression expression;
    std::shared_ptr<const Source>
        source;  ///< its text: the ranges in `expression` are ranges there
    std::vector<std::string> coordinates;
    std::vector<RotationNames> rotations;  ///< whose entries are the last of the variables
    std::vector<Parameter> parameters;  ///< each a symbol of it that is no variable, no name twice
    WholeNumbers sizes;  ///< structural parameters, which are numbers in `expression`
    std::string origin;  ///< the words of the command line without parameters; one line of ASCII

    [[nodiscard]] std::size_t degrees_of_freedom() const {
        return coordinates.size() -
               (rotations_of_space.point - rotations_of_space.tangent) * rotations.size();
    }
};

/// H(q, p) or H(q, p, t), and with rotations H(q, R, p, L).
struct Hamiltonian : MechanicalFunction {
    /// momenta[i] belongs to coordinates[i]. Components of angular momenta follow, without such a
    /// pair.
    std::vector<std::string> momenta;
};

/// Variables in pairs: coordinates and momenta, rotations and angular momenta.
struct VariableNames {
    NameList coordinates, conjugates;
    NameList rotations = {}, angular_momenta = {};  ///< without the indices of their entries
};

/// Reads the Hamiltonian of `--hamiltonian`, `--coordinates` and `--momenta`. Without the last two
/// the variables are q and p, or the pairs q1 and p1, q2 and p2, ... that occur. Names in indices
/// and ranges have their values in `values`. Throws InputError. Precondition: both lists of names
/// are given, or none.
[[nodiscard]] Hamiltonian
hamiltonian_from_text(std::shared_ptr<const Source> expression,
                      const std::shared_ptr<const Source>& coordinates = nullptr,
                      const std::shared_ptr<const Source>& momenta = nullptr,
                      const std::vector<Parameter>& values = {});

/// Makes a Hamiltonian of an expression in `source`, with variables that may be named in other
/// sources; `origin` is left empty. Throws InputError.
[[nodiscard]] Hamiltonian hamiltonian_of(Expression expression,
                                         std::shared_ptr<const Source> source,
                                         const VariableNames& names);

/// Names of the conjugate variables, the momenta or velocities, in messages.
struct ConjugateWords {
    std::string_view subject;  ///< `a momentum`
    std::string_view singular, plural;
};
constexpr ConjugateWords words_of_momenta{"a momentum", "momentum", "momenta"};

/// Declares the names of variables. Throws InputError for names that are reserved or given twice,
/// for too many, and where coordinates and conjugate variables do not form pairs.
[[nodiscard]] Vocabulary declared_variables(const NameList& coordinates, const NameList& conjugate,
                                            const ConjugateWords& words = words_of_momenta);

/// Declares the names of all variables, with the entries of rotations. Throws as above.
[[nodiscard]] Vocabulary declared_variables(const VariableNames& names);

/// Returns the names without their places.
[[nodiscard]] std::vector<std::string> texts(const NameList& list);

/// Throws InputError for words that cannot stand in a function of these variables, of parameters
/// and of the time, and for too many parameters. `subject` is the function's name in messages: `a
/// Hamiltonian`.
void check_words_of(const Expression& function, const std::shared_ptr<const Source>& source,
                    const Vocabulary& variables, std::string_view subject);

/// Throws InputError for functions that cannot stand in an expression of variables and parameters:
/// `roots`, `bspline`. `subject` is the expression's name in messages.
void check_functions(const Expression& expression, const std::shared_ptr<const Source>& source,
                     std::string_view subject);

/// Returns coordinates, then momenta.
[[nodiscard]] std::vector<std::string> variables(const Hamiltonian& hamiltonian);

/// Returns the symbols of H that are parameters, with a value or without, sorted.
[[nodiscard]] std::vector<std::string> parameter_names(const Hamiltonian& hamiltonian);

/// Returns the symbols of a function that are neither variables nor reserved, sorted.
[[nodiscard]] std::vector<std::string> parameter_names(const Expression& function,
                                                       const std::vector<std::string>& variables);

/// Whether the time `t` occurs in H, and is no coordinate.
[[nodiscard]] bool depends_on_time(const Hamiltonian& hamiltonian);
[[nodiscard]] bool depends_on_time(const Expression& function);

/// Throws InputError where a parameter of the method has the name of a variable of H. (A parameter
/// with one name in both is one parameter.)
void check_together(const Method& method, const Hamiltonian& hamiltonian);

/// Throws InputError where a parameter of the method has the name of one of these variables.
/// `owner` is the name in messages of the function that has them: `the Lagrangian`.
void check_together(const Method& method, const std::vector<std::string>& variables,
                    std::string_view owner);

/// Gives a value to a symbol wherever it occurs, in place of an earlier value. Throws InputError
/// when the symbol is a variable, and when neither the method nor H has it. NOTE: a size has had
/// its value since H was read.
void set_parameter(Method& method, Hamiltonian& hamiltonian, Parameter parameter);

/// Throws InputError for a parameter that is none of `names`. `owner` is the name in messages of
/// the function that has the variables.
[[noreturn]] void refuse_parameter(const Parameter& parameter,
                                   const std::vector<std::string>& variables,
                                   std::string_view owner, const std::vector<std::string>& names);

}  // namespace hvi::gen
