// The terms of the equations (4.6) and (4.14) of the general Galerkin form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/equations/stage_terms.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"

namespace hvi::gen {

/// Equations that are to be solved together, and the formulas that follow from their solution.
struct GalerkinEquations {
    std::vector<Equation> positions;           ///< also times T_i, and velocities where they differ
    std::vector<ImplicitEquation> conditions;  ///< on the unknowns
    std::vector<Equation> update;              ///< new coordinates, then momenta
    bool is_exact = true;                      ///< whether each coefficient has a closed form
};

/// Sums over the functions and the nodes of a rule. The unknowns V^j of the coordinate x, the
/// coefficients of its velocity in the basis, are called V_x_1, V_x_2, ...
class GalerkinTerms {
public:
    /// `varying` are the names of variables with a value at each node; other names are `taken`.
    GalerkinTerms(const GalerkinRule& rule, const std::vector<std::string>& coordinates,
                  std::vector<std::string> varying, std::set<std::string> taken);

    /// Returns the name at a node, whose index is 0-based.
    [[nodiscard]] const std::string& name(const std::string& variable, std::size_t node) const {
        return terms_.name(variable, node);
    }
    [[nodiscard]] Expression at_node(const Expression& expression, std::size_t node) const {
        return terms_.in_stage(expression, node);
    }

    /// Returns T_i = t + c_i h at all nodes.
    [[nodiscard]] std::vector<Equation> times();
    /// Returns x + h sum_j A_ij V^j, (4.6c) and (4.14c).
    [[nodiscard]] Expression position(const std::string& x, std::size_t node);
    /// Returns x + h sum_j B_j V^j, (4.6a) and (4.14a).
    [[nodiscard]] Expression position_at_end(const std::string& x);
    /// Returns sum_j psi_j(c_i) V^j, of (4.6e) and (4.14e).
    [[nodiscard]] Expression velocity(const std::string& x, std::size_t node);
    /// Returns the equation of sum_i b_i psi_j(c_i) momentum_i by (4.6d) and (4.14d). Its right
    /// side is B_j p +- h sum_i (b_i B_j - b_i A_ij) slope_i, for the function with the 0-based
    /// index j.
    [[nodiscard]] ImplicitEquation condition(const Expression& momentum, const std::string& p,
                                             const Expression& slope, bool falls,
                                             std::size_t function);
    /// Returns p +- h sum_i b_i slope_i, (4.6b) and (4.14b).
    [[nodiscard]] Expression momentum_at_end(const std::string& p, const Expression& slope,
                                             bool falls);

    [[nodiscard]] bool is_exact() const { return terms_.is_exact(); }

private:
    const GalerkinRule& rule_;
    StageTerms terms_;
};

}  // namespace hvi::gen
