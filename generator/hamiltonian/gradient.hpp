// The derivatives of a Hamiltonian, and of a Lagrangian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// The right sides of Hamilton's equations up to the sign: q' = dH/dp, p' = -dH/dq.
struct Gradient {
    std::vector<Expression> by_coordinates;  ///< dH/dq_i
    std::vector<Expression> by_momenta;      ///< dH/dp_i
};

/// Returns the first derivatives, exact, as one would write them. Parameters with a value are
/// replaced by it. Equal H give equal expressions. Throws InputError with its place for a division
/// by zero, and where a number, a power or the derivatives are too large; MathError with its place
/// where a number is not real.
[[nodiscard]] Gradient gradient(const Hamiltonian& hamiltonian);

/// The derivatives of L: p' = dL/dq and p = dL/dv.
struct LagrangianGradient {
    std::vector<Expression> by_coordinates;  ///< dL/dq_i
    std::vector<Expression> by_velocities;   ///< dL/dv_i
};

/// Returns the first derivatives of L. Throws as gradient() of H does.
[[nodiscard]] LagrangianGradient gradient(const Lagrangian& lagrangian);

}  // namespace hvi::gen
