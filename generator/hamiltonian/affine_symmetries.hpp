// Affine transformations of the coordinates that leave H or L as it is.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// A vector field q' = C q + d of the coordinates, whose flow, lifted to momenta or velocities,
/// leaves H or L as it is.
struct AffineSymmetry {
    std::vector<Expression> generator;  ///< velocities of the coordinates
    Expression momentum_map;            ///< p (C q + d), where on the Lagrangian side p = dL/dv
};

/// [e_i, e_j] = ... + value e_k + ...; those with i < j that are not zero.
struct StructureConstant {
    std::size_t i = 0, j = 0, k = 0;
    Expression value;
};

/// The algebra that the momentum maps span under Poisson's bracket, {q, p} = 1.
struct SymmetryAlgebra {
    std::string name;  ///< `so(3)`; empty where no usual algebra is recognized
    std::optional<std::vector<StructureConstant>> constants;  ///< empty where bodies are alike
};

/// The symmetries of H or L. Those that one would name first stand first.
struct AffineSymmetries {
    std::vector<AffineSymmetry> basis;
    /// Empty where these are proved to be all symmetries, for the values of the parameters or, for
    /// parameters without a value, in general. Otherwise the reason why there may be more.
    std::string doubt;
    /// Empty where brackets lead out of the found symmetries, or where there are more than 24.
    std::optional<SymmetryAlgebra> algebra;
};

/// Finds all affine symmetries. A field xi = C q + d is one if, for all q, p and t,
///
///     H_q xi - H_p (C^T p) = 0,    L_q xi + L_v (C v) = 0,
///
/// These equations are linear in C and d: they are relations among functions (Leok & Zhang, Section
/// 5.1). Parameters stay symbols where the symmetries do not depend on their values. Throws as
/// Algebra does.
[[nodiscard]] AffineSymmetries affine_symmetries(const Hamiltonian& hamiltonian);
[[nodiscard]] AffineSymmetries affine_symmetries(const Lagrangian& lagrangian);

}  // namespace hvi::gen
