// The record that all later stages read: a symplectic partitioned Runge-Kutta method, exact.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

class RationalPolynomial;

/// Origin of a method.
struct Provenance {
    std::string name;               ///< `gauss:2`, or empty for one given by basis and nodes
    std::string origin;             ///< the METHOD of the command line
    std::vector<Expression> basis;  ///< psi_1 .. psi_s, functions of tau, as they were written

    /// Returns the name, or its replacement.
    [[nodiscard]] const std::string& title() const { return name.empty() ? origin : name; }
};

/// Butcher tableaux for q and, with a tilde, for p, which share their weights: all that a step
/// needs to know. Letters as in the paper; indices are 0-based.
struct ButcherPair {
    NumberVector c;  ///< nodes
    NumberVector b;
    NumberMatrix A;
    NumberMatrix A_tilde;  ///< a~_ij = b_j - b_j a_ji / b_i
    NumberVector c_tilde;  ///< row sums of A_tilde

    [[nodiscard]] std::size_t stages() const { return b.size(); }
};

/// Matrices of Algorithm 4.3 between a basis and the tableaux: b = M^-1 B and A = A_psi M^-T.
struct Galerkin {
    NumberMatrix M;  ///< M[i][j] = psi_i(c_j)
    NumberMatrix M_inverse;
    NumberVector B;      ///< B[i] = integral of psi_i over [0,1]
    NumberMatrix A_psi;  ///< A_psi[i][j] = integral of psi_j over [0, c_i]

    /// P over Q whose roots are the nodes, each once, when the basis spans the polynomials of lower
    /// degree over Q: then sums over the stages are rational (see polynomial_stages.hpp). Null
    /// otherwise.
    std::shared_ptr<const RationalPolynomial> node_polynomial;
};

/// A method, with its known properties.
struct Tableau : ButcherPair {
    Provenance provenance;
    std::vector<std::string> parameters;    ///< free symbols in its numbers, sorted
    std::optional<Galerkin> galerkin = {};  ///< empty for what Algorithm 4.3 did not make
    int digits = 0;  ///< digits of the decimals that its numbers are made of; 0: they are exact

    /// Returns Galerkin's node polynomial; null where there is none.
    [[nodiscard]] const RationalPolynomial* node_polynomial() const {
        return galerkin ? galerkin->node_polynomial.get() : nullptr;
    }
};

/// Returns stable text of all numbers, for people and tests.
[[nodiscard]] std::string dump(const Tableau& tableau);

}  // namespace hvi::gen
