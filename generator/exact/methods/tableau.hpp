// The record that everything downstream reads: a symplectic partitioned Runge-Kutta method, exact.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

class RationalPolynomial;

/// The method of Algorithm 4.3 with everything computed on the way. Letters as in the paper; s is
/// the number of stages, indices are 0-based.
struct Tableau {
    std::string name;                     ///< `gauss:2`, or empty for one given by basis and nodes
    std::string origin;                   ///< the METHOD as the command line has it
    std::vector<std::string> parameters;  ///< free symbols, sorted
    std::vector<Expression> basis;        ///< psi_1 .. psi_s, functions of tau

    NumberVector c;  ///< nodes
    NumberMatrix M;  ///< M[i][j] = psi_i(c_j)
    NumberMatrix M_inverse;
    NumberVector B;        ///< B[i] = integral of psi_i over [0,1]
    NumberVector b;        ///< weights, b = M^-1 B
    NumberMatrix A_psi;    ///< A_psi[i][j] = integral of psi_j over [0, c_i]
    NumberMatrix A;        ///< A^phi = A_psi M^-T
    NumberMatrix A_tilde;  ///< a~_ij = b_j - b_j a_ji / b_i
    NumberVector c_tilde;  ///< row sums of A_tilde

    /// P over Q with the nodes for its roots, each once, when the basis spans the polynomials of
    /// lower degree over Q: then sums over the stages are rational (see polynomial_stages.hpp).
    /// Null otherwise, and of no meaning for coefficients that did not come from Algorithm 4.3.
    std::shared_ptr<const RationalPolynomial> node_polynomial;

    [[nodiscard]] std::size_t stages() const { return c.size(); }
};

}  // namespace hvi::gen
