// The motion of rotating bodies, for exact decisions about it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/hamiltonian/algebra.hpp"
#include "generator/hamiltonian/zero.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

/// The motion of H(q, R, p, L), with
///
///     q' = H_p, p' = -H_q, R' = R hat Omega, L' = L x Omega - D,
///
/// where Omega = H_L and D is the derivative of H by turns R exp(hat eta) of a body.
class BodyMotion {
public:
    using Triple = std::vector<GiNaC::ex>;

    /// Throws as Algebra does. Precondition: there are rotations.
    explicit BodyMotion(const Hamiltonian& hamiltonian);

    [[nodiscard]] Algebra& algebra() { return algebra_; }
    [[nodiscard]] const Algebra& algebra() const { return algebra_; }
    [[nodiscard]] std::size_t coordinates() const { return n_; }
    [[nodiscard]] std::size_t rotations() const { return m_; }

    [[nodiscard]] const GiNaC::symbol& q(std::size_t i) const { return variable(i); }
    [[nodiscard]] const GiNaC::symbol& p(std::size_t i) const { return variable(n_ + 9 * m_ + i); }
    /// Returns entry i, j of rotation r, from 0.
    [[nodiscard]] const GiNaC::symbol& R(std::size_t r, std::size_t i, std::size_t j) const {
        return variable(n_ + 9 * r + 3 * i + j);
    }
    [[nodiscard]] const GiNaC::symbol& L(std::size_t r, std::size_t i) const {
        return variable(2 * n_ + 9 * m_ + 3 * r + i);
    }

    [[nodiscard]] GiNaC::ex by(const GiNaC::ex& function, const GiNaC::symbol& variable) const {
        return algebra_.derivative(function, variable);
    }
    /// Returns D of a function.
    [[nodiscard]] Triple by_turns(const GiNaC::ex& function, std::size_t r) const;
    /// Returns the derivatives of a function by L.
    [[nodiscard]] Triple by_momentum(const GiNaC::ex& function, std::size_t r) const;

    /// Returns {I, H}, the derivative of I along the motion.
    [[nodiscard]] GiNaC::ex bracket(const GiNaC::ex& I) const;

    /// Whether a function is zero for all rotations. It is proved where the function is zero for
    /// all matrices, or for the rotations of all quaternions; it is refuted by enclosures at
    /// rotations.
    [[nodiscard]] Vanishing vanishes(const GiNaC::ex& function) const;

    /// Replaces each matrix in a point by a rotation.
    [[nodiscard]] SymbolValues with_rotations(SymbolValues point) const;

private:
    [[nodiscard]] const GiNaC::symbol& variable(std::size_t i) const {
        return algebra_.variables()[i];
    }
    [[nodiscard]] bool is_refuted(const GiNaC::ex& function) const;
    [[nodiscard]] GiNaC::ex of_quaternions(const GiNaC::ex& function) const;

    Algebra algebra_;
    std::size_t n_, m_;
};

}  // namespace hvi::gen
