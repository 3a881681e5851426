// Newton's method by products of second derivatives with vectors.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/solvers/newton_structured.hpp>

namespace hvi {

/// Solver policy of steppers of systems in which all degrees of freedom are coupled, with quadratic
/// kinetic energy.
struct NewtonOfProducts {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration = detail::NewtonLoop<Vector, detail::ProductEquations<Vector>>;
};

}  // namespace hvi
