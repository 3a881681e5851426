// The motion of rotating bodies, for what is decided exactly of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/hamiltonian/algebra.hpp"
#include "generator/hamiltonian/zero.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

/// H(q, R, p, L), with
///
///     q' = H_p, p' = -H_q, R' = R hat Omega, L' = L x Omega - D,
///
/// where Omega = H_L and D is the derivative of H by turns R exp(hat eta) of a body.
class BodyMotion {
public:
    using Triple = std::vector<GiNaC::ex>;

    /// Throws what Algebra throws. Precondition: there are rotations.
    explicit BodyMotion(const Hamiltonian& hamiltonian);

    [[nodiscard]] Algebra& algebra() { return algebra_; }
    [[nodiscard]] const Algebra& algebra() const { return algebra_; }
    [[nodiscard]] std::size_t coordinates() const { return n_; }
    [[nodiscard]] std::size_t rotations() const { return m_; }

    [[nodiscard]] const GiNaC::symbol& q(std::size_t i) const { return variable(i); }
    [[nodiscard]] const GiNaC::symbol& p(std::size_t i) const { return variable(n_ + 9 * m_ + i); }
    /// Entry i, j of rotation r, from 0.
    [[nodiscard]] const GiNaC::symbol& R(std::size_t r, std::size_t i, std::size_t j) const {
        return variable(n_ + 9 * r + 3 * i + j);
    }
    [[nodiscard]] const GiNaC::symbol& L(std::size_t r, std::size_t i) const {
        return variable(2 * n_ + 9 * m_ + 3 * r + i);
    }

    [[nodiscard]] GiNaC::ex by(const GiNaC::ex& function, const GiNaC::symbol& variable) const {
        return algebra_.derivative(function, variable);
    }
    /// D of a function.
    [[nodiscard]] Triple by_turns(const GiNaC::ex& function, std::size_t r) const;
    /// Its derivatives by L.
    [[nodiscard]] Triple by_momentum(const GiNaC::ex& function, std::size_t r) const;

    /// {I, H}, the derivative of I along the motion.
    [[nodiscard]] GiNaC::ex bracket(const GiNaC::ex& I) const;

    /// Whether a function is zero for all rotations: proved where it is so for all matrices, or
    /// when those of quaternions are put in; refuted by enclosures at rotations.
    [[nodiscard]] Vanishing vanishes(const GiNaC::ex& function) const;

    /// The same point with a rotation in place of each matrix.
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
