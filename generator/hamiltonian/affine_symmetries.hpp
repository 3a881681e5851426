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
    std::vector<Expression> generator;  ///< of each coordinate
    Expression momentum_map;            ///< p (C q + d), where on the Lagrangian side p = dL/dv
};

/// [e_i, e_j] = ... + value e_k + ...; those with i < j that are not zero.
struct StructureConstant {
    std::size_t i = 0, j = 0, k = 0;
    Expression value;
};

/// What the momentum maps span under Poisson's bracket, {q, p} = 1.
struct SymmetryAlgebra {
    std::string name;  ///< `so(3)`; empty where it is not one of the usual, or not seen to be
    std::optional<std::vector<StructureConstant>> constants;  ///< empty where all bodies are alike
};

/// Those that there are; on the left those that one would name first.
struct AffineSymmetries {
    std::vector<AffineSymmetry> basis;
    /// Empty where these are all, for the values that the parameters have or, where they have none,
    /// in general; else why there may be more.
    std::string doubt;
    /// Empty where brackets lead out of what was found, or there are more than 24.
    std::optional<SymmetryAlgebra> algebra;
};

/// With xi = C q + d it is that, for all q, p and t,
///
///     H_q xi - H_p (C^T p) = 0,    L_q xi + L_v (C v) = 0,
///
/// which is linear in C and d: relations among functions (Leok & Zhang, Section 5.1). Parameters
/// stay symbols where the symmetries do not depend on their values. Throws what Algebra throws.
[[nodiscard]] AffineSymmetries affine_symmetries(const Hamiltonian& hamiltonian);
[[nodiscard]] AffineSymmetries affine_symmetries(const Lagrangian& lagrangian);

}  // namespace hvi::gen
