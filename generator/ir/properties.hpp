// What is known of H where a step is planned.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/expr/side.hpp"

namespace hvi::gen {

/// How Newton's method solves with G = d2U/dq2, where the momenta of the stages are eliminated.
enum class HessianForm {
    dense,     ///< G is a matrix, and so is J
    band,      ///< of a chain: entries are near the diagonal, in an order found at run time
    sparse,    ///< each degree of freedom is coupled with few others
    products,  ///< G is not kept: its products with vectors are computed
    none,      ///< there is no Newton's method: H is made of totals, which couple all
};

/// Components k each by itself: (d2H/dp2)_kk (d2H/dq2)_kk has a constant term.
struct StiffComponents {
    std::vector<std::size_t> components;

    friend bool operator==(const StiffComponents&, const StiffComponents&) = default;
};

/// Constant terms of second derivatives couple components.
struct CoupledConstants {
    friend bool operator==(const CoupledConstants&, const CoupledConstants&) = default;
};

/// What of the equations of the stages is linear, and can be solved exactly in each sweep; see
/// ConstantTerms.
using LinearPart = std::variant<std::monostate, StiffComponents, CoupledConstants>;

[[nodiscard]] inline bool exists(const LinearPart& part) {
    return !std::holds_alternative<std::monostate>(part);
}

/// What evaluations cost, in additions about, as OperationCounts tell.
struct EvaluationCosts {
    double by_q = 0;         ///< dH/dq
    double by_p_at_q = 0;    ///< dH/dp, where what depends on q alone is there
    double joint = 0;        ///< both at the same q and p
    double second = 0;       ///< all second derivatives
    bool has_calls = false;  ///< of sin, exp, ... in the first ones

    friend bool operator==(const EvaluationCosts&, const EvaluationCosts&) = default;
};

/// The kind of vectors that a state holds.
enum class Container {
    of_user,  ///< the class of a user says so
    arrays,   ///< of a size that is known when the header is written
    vectors,  ///< of any size
};
[[nodiscard]] std::string_view to_text(Container container);

/// Of the H of a scene what its graph proves, see Structure; of that of a class of the user what he
/// says. What is false may be true and not seen.
struct SystemProperties {
    Side side = Side::hamiltonian;
    bool is_separable = false;           ///< H = T(p) + U(q), or T(p) + U(q, t)
    bool depends_on_time = false;        ///< H = H(q, p, t)
    bool kinetic_is_quadratic = false;   ///< it is separable, and T = p^T K p/2 with constant K
    bool has_diagonal_mass = false;      ///< and K is diagonal
    bool has_linear_map = false;         ///< all second derivatives are constant, without t
    bool is_degenerate = false;          ///< a row of d2H/dp2 is zero
    std::size_t degrees_of_freedom = 0;  ///< 0: not known
    std::size_t rotations = 0;           ///< of them, with three each
    LinearPart linear = {};
    Container container = Container::of_user;
    bool is_lattice = false;  ///< see Sites
    HessianForm hessian = HessianForm::dense;
    EvaluationCosts costs = {};     ///< zeros: not known
    std::size_t shared_slopes = 0;  ///< values that dH/dp takes from the dH/dq at the same q

    friend bool operator==(const SystemProperties&, const SystemProperties&) = default;
};

/// Stable text, for people and tests: a line for each property that is there.
[[nodiscard]] std::string dump(const SystemProperties& system);

/// Stops the program (HVI_CHECK) where the record contradicts itself.
void verify(const SystemProperties& system);

}  // namespace hvi::gen
