// The record that everything downstream reads: a symplectic partitioned Runge-Kutta method, exact.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/exact/number.hpp"

namespace hvi::gen {

using NumberVector = std::vector<Number>;
using NumberMatrix = std::vector<std::vector<Number>>;  ///< rows

/// The method of Algorithm 4.3 with everything computed on the way. Letters as in the paper; s is
/// the number of stages, indices are 0-based.
struct Tableau {
    std::string name;                     ///< `gauss:2`, or empty for one given by basis and nodes
    std::string origin;                   ///< the METHOD as the command line has it
    std::vector<std::string> parameters;  ///< free symbols, sorted
    std::vector<Expression> basis;        ///< psi_1 .. psi_s, functions of tau

    NumberVector c;  ///< nodes
    /// The monic polynomial over Q whose roots are the nodes, lowest coefficient first, where it is
    /// known and the basis spans the polynomials of degree less than s; else empty. Sums over the
    /// nodes are rational then, be there closed forms or not.
    NumberVector P;
    NumberMatrix M;  ///< M[i][j] = psi_i(c_j)
    NumberMatrix M_inverse;
    NumberVector B;        ///< B[i] = integral of psi_i over [0,1]
    NumberVector b;        ///< weights, b = M^-1 B
    NumberMatrix A_psi;    ///< A_psi[i][j] = integral of psi_j over [0, c_i]
    NumberMatrix A;        ///< A^phi = A_psi M^-T
    NumberMatrix A_tilde;  ///< a~_ij = b_j - b_j a_ji / b_i
    NumberVector c_tilde;  ///< row sums of A_tilde

    [[nodiscard]] std::size_t stages() const { return c.size(); }
};

}  // namespace hvi::gen
