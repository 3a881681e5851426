// Properties of H that a step is planned from.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/expr/side.hpp"
#include "generator/expr/small_steps.hpp"

namespace hvi::gen {

/// Ways of Newton's method to solve with G = d2U/dq2, where the momenta of the stages are
/// eliminated.
enum class HessianForm {
    dense,     ///< G is a matrix, and so is J
    band,      ///< G of a chain: entries are near the diagonal, in an order found at run time
    sparse,    ///< each degree of freedom is coupled with few others
    products,  ///< G is not kept: its products with vectors are computed
    none,      ///< no Newton's method: H is made of totals, which couple all
};

/// Components k that are solved for each by itself: (d2H/dp2)_kk (d2H/dq2)_kk has a constant term.
struct StiffComponents {
    std::vector<std::size_t> components;

    friend bool operator==(const StiffComponents&, const StiffComponents&) = default;
};

/// Constant terms of second derivatives that couple components.
struct CoupledConstants {
    friend bool operator==(const CoupledConstants&, const CoupledConstants&) = default;
};

/// Linear part of the stage equations that can be solved exactly in each sweep; see ConstantTerms.
using LinearPart = std::variant<std::monostate, StiffComponents, CoupledConstants>;

[[nodiscard]] inline bool exists(const LinearPart& part) {
    return !std::holds_alternative<std::monostate>(part);
}

/// Costs of evaluations, in additions approximately, from OperationCounts.
struct EvaluationCosts {
    double by_q = 0;         ///< dH/dq
    double by_p_at_q = 0;    ///< dH/dp, where the parts that depend on q alone are known
    double joint = 0;        ///< both at the same q and p
    double second = 0;       ///< all second derivatives
    bool has_calls = false;  ///< of sin, exp, ... in dH/dq or dH/dp

    friend bool operator==(const EvaluationCosts&, const EvaluationCosts&) = default;
};

/// Kinds of vectors in a state.
enum class Container {
    of_user,  ///< a class of the user chooses
    arrays,   ///< of a size that is known when the header is written
    vectors,  ///< of any size
};
[[nodiscard]] std::string_view to_text(Container container);

/// Properties of H. For the H of a scene they are proved by its graph, see Structure; for a class
/// of the user they are stated by the user. A property that is false here may be true and not seen.
struct SystemProperties {
    Side side = Side::hamiltonian;
    bool is_separable = false;           ///< H = T(p) + U(q), or T(p) + U(q, t)
    bool depends_on_time = false;        ///< H = H(q, p, t)
    bool kinetic_is_quadratic = false;   ///< H is separable, and T = p^T K p/2 with constant K
    bool has_diagonal_mass = false;      ///< and K is diagonal
    bool has_linear_map = false;         ///< all second derivatives are constant, without t
    bool is_degenerate = false;          ///< a row of d2H/dp2 is zero
    std::size_t degrees_of_freedom = 0;  ///< 0: not known
    std::size_t rotations = 0;           ///< among the degrees of freedom, three for each
    LinearPart linear = {};
    Container container = Container::of_user;
    std::size_t parts = 0;  ///< parts whose flows make up the steps; 0: there are none
    SmallSteps small_steps = {};
    std::optional<std::size_t> clock = {};  ///< part with whose flow the time goes on
    bool is_lattice = false;  ///< whether there are sites; see Sites
    HessianForm hessian = HessianForm::dense;
    EvaluationCosts costs = {};     ///< zeros: not known
    std::size_t shared_slopes = 0;  ///< values that dH/dp takes from the dH/dq at the same q

    friend bool operator==(const SystemProperties&, const SystemProperties&) = default;
};

/// Returns stable text, for people and tests: a line for each property that holds.
[[nodiscard]] std::string dump(const SystemProperties& system);

/// Stops the program (HVI_CHECK) where the record contradicts itself.
void verify(const SystemProperties& system);

}  // namespace hvi::gen
