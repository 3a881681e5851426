// A Hamiltonian or Lagrangian system: what a scene says, as one graph, and what is found in it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/graph/graph.hpp"
#include "generator/ir/properties.hpp"

namespace hvi::gen {

/// A block of a Hessian; a zero entry is proved to be one.
using HessianBlock = std::vector<std::vector<Scaled>>;

/// The second derivatives of H, or of L, all in the system's graph.
struct Hessian {
    HessianBlock qq;
    HessianBlock mixed;       ///< [i][j] by q_i and the conjugate of q_j
    HessianBlock conjugates;  ///< by p, or by v
};

/// A constant term of (d2H/dp2)_kk (d2H/dq2)_kk, as of a linear spring the square of a frequency.
struct LinearStiffness {
    std::size_t component;  ///< k
    Scaled value;
};

/// Terms of second derivatives that do not vary: of springs, or of a magnetic field. Those of
/// components that are coupled with no other, where T is quadratic, or of all; nothing where no
/// motion comes from them alone.
using ConstantTerms = std::variant<std::monostate, std::vector<LinearStiffness>, Hessian>;

/// What the derivatives of H tell; of an L nothing is looked for. What is true here is proved: a
/// graph computes by exact algebra, and what it does not see to be constant may be proved so in a
/// field; see constant_value(). What is false may be true and hidden: exp(q) exp(-q) q + p.
struct Structure {
    bool is_separable = false;          ///< H = T(p) + U(q), or T(p) + U(q, t)
    bool kinetic_is_quadratic = false;  ///< and T is quadratic, with a constant matrix d2H/dp2
    bool has_diagonal_mass = false;     ///< and that matrix is diagonal
    std::vector<Scaled> inverse_mass;   ///< then K p, for T = p^T K p/2 and what is linear in p
    std::vector<Node> direction;        ///< then inputs v_k of their own,
    std::vector<Scaled> qq_along;       ///< and d2H/dq2 v
    ConstantTerms constant;
    bool is_quadratic = false;       ///< all second derivatives are constant
    bool has_linear_map = false;     ///< and H has no t: all steps are one linear map
    std::vector<Scaled> by_q, by_p;  ///< then the first derivatives at q = p = 0
    bool is_linear_in_p = false;     ///< d2H/dp2 is zero, and not all else
    bool is_linear_in_q = false;
};

/// Whether H has terms that are linear in q or p. Precondition: has_linear_map.
[[nodiscard]] bool has_linear_part(const Structure& quadratic);

/// Whether H does not depend on some momentum, or not more than linearly: a row of d2H/dp2 is zero.
[[nodiscard]] bool is_degenerate(const Hessian& hessian);

/// A parameter that stays one: its value is a default.
struct SystemParameter {
    std::string name;
    Expression value;
    Node node = 0;
};

/// An expression of the scene with its name.
struct SystemValue {
    std::string name;
    Expression expression;  ///< as it was written
    Scaled value;
};

/// A rotation from body to space, and its angular momentum in the body, by their names.
struct SystemRotation {
    std::string rotation, momentum;
};

/// H(q, p) or L(q, v), its variables, its derivatives, and what else a scene has. What they have in
/// common is one node. The conjugates are the momenta, or on the Lagrangian side the velocities;
/// there the momenta are names alone.
struct System {
    std::string name, description;  ///< of the scene; may be empty
    Side side = Side::hamiltonian;
    Expression expression;  ///< of the function, as it was written
    std::vector<std::string> coordinates, momenta;
    std::vector<SystemRotation> rotations;  ///< their entries are the last of these, nine and three
    std::vector<std::string> velocities;    ///< on the Lagrangian side
    std::vector<SystemParameter> parameters;  ///< in the order of the scene
    std::vector<std::string> own_headers;     ///< of functions of the user's own

    Graph graph;
    std::vector<Node> q, conjugates;  ///< inputs, in the order of their names
    std::optional<Node> time;         ///< the input t, where the function depends on it
    Scaled function;                  ///< H or L
    Scaled energy;                    ///< H, or v dL/dv - L
    /// The first derivatives, by each degree of freedom: of a rotation those by turns of the body;
    /// see by_turns().
    std::vector<Scaled> by_q, by_conjugates;
    Hessian hessian;                      ///< the same; of rotations the block qq is not symmetric
    Structure structure;                  ///< of H
    std::vector<SystemValue> initial;     ///< of coordinates, then of conjugates; or empty
    std::vector<SystemValue> invariants;  ///< in the order of the scene

    /// NOTE: a rotation has three, and nine q.
    [[nodiscard]] std::size_t degrees_of_freedom() const { return conjugates.size(); }
    /// Those that are not of rotations.
    [[nodiscard]] std::size_t flat_coordinates() const { return q.size() - 9 * rotations.size(); }
    /// The q_i that do not occur in the function, so that p_i stays.
    [[nodiscard]] std::vector<std::size_t> cyclic_coordinates() const;
    /// `p` or `v` as the scene names them.
    [[nodiscard]] const std::vector<std::string>& conjugate_names() const {
        return side == Side::hamiltonian ? momenta : velocities;
    }
    /// `H` or `L`, and what its conjugates are called, `p` or `v`.
    [[nodiscard]] char function_letter() const { return side == Side::hamiltonian ? 'H' : 'L'; }
    [[nodiscard]] char conjugate_letter() const { return side == Side::hamiltonian ? 'p' : 'v'; }
};

/// Stable text, for people and tests: what each node computes, `#7: product #3 #4`, and which nodes
/// are the function, its derivatives, the initial data and the invariants.
[[nodiscard]] std::string dump(const System& system);

/// Stops the program (HVI_CHECK) where the record contradicts itself: a node that needs a later one
/// or depends on something else than its arguments, tables of other sizes than there are variables.
void verify(const System& system);

/// Whether the texts are.
[[nodiscard]] bool operator==(const System& left, const System& right);

}  // namespace hvi::gen
